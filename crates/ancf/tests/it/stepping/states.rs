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
