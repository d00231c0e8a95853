//! States that a program sets.

use ancf::{CompleteState, StepError, Stepper};

use crate::common::models::parse;

/// Pendulum of one rigid body about z: a cylinder of length 2 at its end.
fn pendulum(scales: &str) -> String {
    format!(
        "{scales}gravity = [0, -9.81, 0]\n\
         bodies = [{{ kind = \"rigid\", name = \"rod\", center = [1, 0, 0], mass = 3, inertia = [0.1, 1, 1] }}]\n\
         probes = [{{ name = \"rod\", on = {{ body = \"rod\", at = \"center\" }} }}]\n\
         [[joints]]\nkind = \"revolute\"\nname = \"pin\"\na = {{ body = \"rod\", at = [0, 0, 0] }}\naxis = [0, 0, 1]\n\
         [analysis]\nkind = \"dynamics\"\nduration = 1\nstep = 1e-3\nscheme = {{ spectral_radius = 0.9 }}\n"
    )
}

const SCALES: [&str; 2] = ["", "scales = { kind = \"given\", length = 3, force = 0.7, time = 0.13 }\n"];

/// Its own state changes nothing but the history: the continuation agrees to the error of the scheme.
#[test]
fn own_state_is_consistent() {
    for scales in SCALES {
        let model = parse(&pendulum(scales));
        let [mut stepper, mut other] = [0; 2].map(|_| Stepper::new(&model).unwrap());
        stepper.advance(0.4).unwrap();
        let state = stepper.state();
        let report = other.set_state(&state).unwrap();
        assert!(report.moved < 1e-12 && report.corrected < 1e-6, "{report:?}");
        assert_eq!(other.time(), stepper.time());
        let _ = [&mut stepper, &mut other].map(|one| one.advance(0.8).unwrap());
        let [a, b] = [&mut stepper, &mut other].map(|one| one.read("rod.y").unwrap());
        assert!((a - b).abs() < 1e-6, "{a} {b}");
        assert!(other.read("balance").unwrap().abs() < 1e-4);
    }
}

/// A state off the constraints is projected, and its distance is stated; energies begin anew.
#[test]
fn given_states_are_projected() {
    for scales in SCALES {
        let mut stepper = Stepper::new(&parse(&pendulum(scales))).unwrap();
        let mut state = stepper.state();
        let layout = stepper.layout();
        assert_eq!((layout[0].name.as_str(), layout[0].first), ("rod", 0));
        assert_eq!(layout[0].are_positions, [true, false, false, false]);
        assert!((layout[0].reference[0][0] - 1.0).abs() < 1e-12);
        // The hinge holds the centre: it returns.
        state.coordinates[1] = 0.01;
        state.velocities[1] = 2.0;
        let report = stepper.set_state(&state).unwrap();
        assert!(report.moved > 1e-3 && report.moved < 0.02, "{report:?}");
        assert!(report.corrected > 0.01, "{report:?}");
        let [x, y] = ["rod.x", "rod.y"].map(|name| stepper.read(name).unwrap());
        assert!((x.hypot(y) - 1.0).abs() < 1e-12);
        assert_eq!(stepper.read("work").unwrap(), 0.0);
        // Projection conserves the momentum along the free motion, J ω = 2 m with J = 4 m/3 plus the share of directions.
        let v = stepper.read("rod.vy").unwrap();
        assert!(v > 0.5 && v < 2.0, "{v}");
        stepper.advance(0.5).unwrap();
        assert!(stepper.read("balance").unwrap().abs() < 1e-4);
    }
}

/// A state keeps the full turns of the angles of hinges and sensors, also after other states. Without them, angles are within a turn.
#[test]
fn states_keep_full_turns() {
    let text = r#"
        bodies = [{ kind = "rigid", name = "b", center = [0.1, 0, 0], mass = 1, inertia = [0.1, 0.1, 0.1], motion = { spin = [0, 0, 40], about = [0, 0, 0] } }]
        joints = [{ kind = "revolute", name = "h", a = { body = "b", at = [0, 0, 0] }, axis = [0, 0, 1] }]
        analysis = { kind = "dynamics", duration = 1, step = 1e-3 }
    "#;
    let mut stepper = Stepper::new(&parse(text)).unwrap();
    let start = stepper.state();
    stepper.advance(0.4).unwrap();
    let (turned, angle) = (stepper.state(), stepper.read("h.angle").unwrap());
    assert!((angle - 16.0).abs() < 0.01 && turned.angles == [angle], "{angle}");
    for (state, expected) in [(&turned, angle), (&start, 0.0), (&turned, angle)] {
        stepper.set_state(state).unwrap();
        assert!((stepper.read("h.angle").unwrap() - expected).abs() < 1e-9);
    }
    stepper.set_state(&CompleteState { angles: Vec::new(), ..turned.clone() }).unwrap();
    assert!((stepper.read("h.angle").unwrap() - (angle - 6.0 * std::f64::consts::PI)).abs() < 1e-9);
    let wrong = CompleteState { angles: vec![0.0, 1.0], ..turned };
    assert!(stepper.set_state(&wrong).unwrap_err().to_string().contains("angles"));
}

/// Inputs keep their values in a state of an earlier time, also those that were set last, and transitions continue. Accelerations have
/// these values.
#[test]
fn inputs_keep_their_values_in_states() {
    let text = r#"
        inputs = [{ name = "u", value = 1 }]
        bodies = [{ kind = "mass", name = "b", center = [0, 0, 0], mass = 2 }]
        loads = [{ kind = "force", on = { body = "b", at = "center" }, force = [1, 0, 0], time = { kind = "input", name = "u" } }]
        probes = [{ name = "p", on = { body = "b", at = "center" } }]
        analysis = { kind = "dynamics", duration = 1, step = 1e-3 }
    "#;
    let mut stepper = Stepper::new(&parse(text)).unwrap();
    let start = stepper.state();
    let acceleration = |stepper: &mut Stepper| stepper.read("p.ax").unwrap();
    stepper.advance(0.1).unwrap();
    stepper.set("u", 5.0).unwrap();
    stepper.advance(0.2).unwrap();
    stepper.set_state(&start).unwrap();
    assert_eq!((stepper.input("u").unwrap(), acceleration(&mut stepper)), (5.0, 2.5));
    stepper.advance(0.05).unwrap();
    assert_eq!(acceleration(&mut stepper), 2.5);
    stepper.set("u", 3.0).unwrap();
    stepper.set_state(&start).unwrap();
    assert_eq!((stepper.input("u").unwrap(), acceleration(&mut stepper)), (3.0, 1.5));
    stepper.advance(0.5).unwrap();
    stepper.set_within("u", 1.0, 0.4).unwrap();
    stepper.advance(0.6).unwrap();
    stepper.set_state(&start).unwrap();
    for (t, u) in [(0.0, 2.5), (0.1, 2.0), (0.3, 1.0), (0.5, 1.0)] {
        stepper.advance(t).unwrap();
        assert!(
            (stepper.input("u").unwrap() - u).abs() < 1e-9
                && (acceleration(&mut stepper) - 0.5 * u).abs() < 1e-9,
            "{t}"
        );
    }
}

#[test]
fn invalid_states_change_nothing() {
    let mut stepper = Stepper::new(&parse(&pendulum(""))).unwrap();
    stepper.advance(0.1).unwrap();
    let (saved, state) = (stepper.save().unwrap(), stepper.state());
    let short = CompleteState { coordinates: vec![0.0], ..state.clone() };
    let infinite = CompleteState { velocities: vec![f64::INFINITY; 12], ..state.clone() };
    let early = CompleteState { time: -1.0, ..state.clone() };
    for wrong in [short, infinite, early] {
        assert!(matches!(stepper.set_state(&wrong), Err(StepError::Argument(_))));
    }
    let far = CompleteState { coordinates: vec![1e9; 12], ..state };
    assert!(stepper.set_state(&far).is_err());
    assert_eq!(stepper.save().unwrap(), saved);
}

/// The mixed derivatives of a flat shell are zero in the reference state: their references are zero vectors.
#[test]
fn layouts_of_shells_are_finite() {
    let model = parse(
        "materials.m = { density = 1100, young = 5e9 }\n\
         bodies = [{ kind = \"shell\", name = \"p\", surface = { kind = \"flat\", corner = [0, 0, 0], side_u = [1, 0, 0], \
         side_v = [0, 2, 0] }, elements = [2, 2], thickness = 0.01, material = \"m\" }]\n\
         joints = [{ kind = \"support\", name = \"s\", a = { body = \"p\", at = { edge = \"u_start\" } }, condition = \"clamped\" }]\n\
         [analysis]\nkind = \"dynamics\"\nduration = 1\nstep = 1e-3\n",
    );
    let layout = Stepper::new(&model).unwrap().layout();
    let sizes = layout[0].reference.iter().zip(&layout[0].are_positions);
    let sizes: Vec<f64> =
        sizes.filter(|(_, is)| !**is).map(|(r, _)| r.iter().map(|x| x * x).sum::<f64>().sqrt()).collect();
    assert_eq!(sizes.len(), 27);
    assert!(sizes.iter().all(|size| size.abs() < 1e-12 || (size - 1.0).abs() < 1e-12), "{sizes:?}");
}

/// A simulation continues in its own state with the same reactions. The error of the time steps in the velocities along constraints would
/// change the strain rates of the section in the clamp.
#[test]
fn reactions_continue_in_own_states() {
    let text = r#"
        materials.s = { density = 7850, poisson = 0.3, young = 2.1e11, damping = { strain = 1e-3 } }
        sections.q = { kind = "rectangle", height = 0.01, width = 0.02 }
        bodies = [
          { kind = "beam", name = "arm", from = [0.1, 0, 0], to = [1, 0, 0], elements = 4, section = "q", material = "s", motion = { about = [0, 0, 0], spin = [0, 0, 10] } },
          { kind = "rigid", name = "hub", center = [0, 0, 0], mass = 1, inertia = [0.1, 0.1, 0.1], motion = { spin = [0, 0, 10] } },
        ]
        joints = [
          { kind = "revolute", name = "axle", axis = [0, 0, 1], a = { body = "hub", at = "center" } },
          { kind = "clamp", name = "root", a = { body = "arm", at = "start" }, b = { body = "hub", at = [0.1, 0, 0] } },
        ]
        loads = [{ kind = "force", on = { body = "arm", at = "end" }, force = [0, 20, 0] }]
        analysis = { kind = "dynamics", duration = 1, step = 4e-3 }
    "#;
    let mut stepper = Stepper::new(&parse(text)).unwrap();
    stepper.advance(0.4).unwrap();
    let columns = ["root.fx", "root.fy", "root.mz"];
    let before = columns.map(|name| stepper.read(name).unwrap());
    let state = stepper.state();
    stepper.set_state(&state).unwrap();
    for (name, before) in columns.into_iter().zip(before) {
        let after = stepper.read(name).unwrap();
        assert!((after - before).abs() < 1e-3 * before.abs(), "{name}: {before} and {after}");
    }
}

/// The equations of a driven hinge also hold half a turn from its angle. A state there is rejected.
#[test]
fn states_half_a_turn_from_a_drive_are_rejected() {
    let text = r#"
        bodies = [{ kind = "rigid", name = "r", center = [0, 0, 0], mass = 1, inertia = [0.1, 0.2, 0.3] }]
        joints = [{ kind = "revolute", name = "h", a = { body = "r", at = "center" }, axis = [0, 0, 1], drive = { rate = 2 } }]
        analysis = { kind = "dynamics", duration = 1, step = 1e-2 }
    "#;
    let mut stepper = Stepper::new(&parse(text)).unwrap();
    stepper.advance(0.1).unwrap();
    let state = stepper.state();
    let error = stepper.set_state(&CompleteState { time: 1.6, ..state.clone() }).unwrap_err().to_string();
    assert!(error.contains("half a turn"), "{error}");
    assert!((stepper.read("h.angle").unwrap() - 0.2).abs() < 1e-9);
    stepper.set_state(&CompleteState { time: 0.4, ..state }).unwrap();
    assert!((stepper.read("h.angle").unwrap() - 0.8).abs() < 1e-9);
}
