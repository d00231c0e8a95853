//! Motions that steps of fixed size do not resolve, and results that do not depend on the choice of directors.

use ancf::{Model, Outcome};
use nalgebra::{Rotation3, Vector3};

use crate::common::models::parse;
use crate::common::solutions::Run;

fn vector(run: &Run, owner: &str, [x, y, z]: [&str; 3], row: usize) -> Vector3<f64> {
    let at = |name: &str| run.column(&format!("{owner}.{name}"))[row];
    Vector3::new(at(x), at(y), at(z))
}

/// Two bodies on a hinge: its rate is e·(ω_b − ω_a) with the axis e of `a`, to rounding. Directions normal to the axis violate
/// the constraints at the level of velocities.
#[test]
fn the_rate_of_a_hinge_is_the_relative_angular_velocity() {
    let run = Run::of(&parse(
        r#"
bodies = [
  { kind = "rigid", name = "a", center = [0, 0, 0], mass = 1, inertia = [0.02, 0.03, 0.045], motion = { spin = [1, 9, 2] } },
  { kind = "rigid", name = "b", center = [0.2, 0.4, 0.4], mass = 2, inertia = [0.02, 0.05, 0.04], motion = { spin = [1, 9, 2], about = [0, 0, 0] } },
]
joints = [{ kind = "revolute", name = "j", a = { body = "b", at = [0, 0, 0] }, b = { body = "a", at = [0, 0, 0] }, axis = [1, 2, 2] }]
loads = [{ kind = "force", on = { body = "b", at = [0.3, 0, 0] }, force = [3, -8, 15] }]
probes = [
  { name = "b", on = { body = "b", at = [0, 0, 0] }, record = ["rotation"] },
  { name = "a", on = { body = "a", at = [0, 0, 0] }, record = ["motion", "rotation"] },
  { name = "axis", on = { body = "a", at = [1, 2, 2] }, record = ["motion"] },
]
analysis = { kind = "dynamics", duration = 0.4, step = 0.01, scheme = { spectral_radius = 0.8 } }
"#,
    ));
    for row in 0..run.column("t").len() {
        let axis = vector(&run, "axis", ["x", "y", "z"], row) - vector(&run, "a", ["x", "y", "z"], row);
        let [of_a, of_b] = ["a", "b"].map(|body| vector(&run, body, ["wx", "wy", "wz"], row));
        let (found, exact) = (run.column("j.rate")[row], axis.dot(&(of_b - of_a)) / 3.0);
        assert!((found - exact).abs() < 1e-11 * 22.0, "row {row}: {found} for {exact}");
    }
}

/// Body of spherical inertia under two moments, in a rotated frame.
fn turned_by_moments(angles: [f64; 3]) -> Model {
    let turned = Rotation3::from_euler_angles(angles[0], angles[1], angles[2]);
    let list = |x: [f64; 3]| format!("{:?}", <[f64; 3]>::from(turned * Vector3::from(x)));
    parse(&format!(
        r#"
bodies = [{{ kind = "rigid", name = "b", center = [0, 0, 0], mass = 1, inertia = [0.02, 0.02, 0.02], motion = {{ spin = {} }} }}]
loads = [
  {{ kind = "moment", on = {{ body = "b", at = "center" }}, moment = {} }},
  {{ kind = "moment", on = {{ body = "b", at = "center" }}, moment = {}, follower = true }},
]
analysis = {{ kind = "dynamics", duration = 0.5, step = 0.01, scheme = {{ spectral_radius = 0.8 }} }}
"#,
        list([3.0, -8.0, 5.0]),
        list([0.4, 0.9, -0.5]),
        list([0.3, -0.7, 0.2]),
    ))
}

/// The work of moments on a rigid body does not depend on the directors by which they act.
#[test]
fn the_work_of_moments_is_independent_of_the_frame() {
    let [one, other] = [[0.0; 3], [0.7, -1.1, 2.3]].map(|angles| Run::of(&turned_by_moments(angles)));
    for (row, (a, b)) in one.column("work").iter().zip(other.column("work")).enumerate() {
        assert!((a - b).abs() < 1e-12 * (1.0 + a.abs()), "row {row}: {a}, {b}");
    }
    assert!(one.last("work").abs() > 0.1, "{}", one.last("work"));
}

/// A moment turns a body by more than a radian per step. The rigidity constraints also hold for the mirror image of the body.
#[test]
fn a_rigid_body_is_not_turned_inside_out() {
    let model = parse(
        r#"
bodies = [{ kind = "rigid", name = "b", center = [0, 0, 0], mass = 0.4, inertia = [9e-4, 8e-4, 5e-4] }]
loads = [{ kind = "moment", on = { body = "b", at = "center" }, moment = [300, 60, -350] }]
probes = [
  { name = "o", on = { body = "b", at = "center" }, record = ["motion"] },
  { name = "x", on = { body = "b", at = [1, 0, 0] }, record = ["motion"] },
  { name = "y", on = { body = "b", at = [0, 1, 0] }, record = ["motion"] },
  { name = "z", on = { body = "b", at = [0, 0, 1] }, record = ["motion"] },
]
analysis = { kind = "dynamics", duration = 0.03, step = 1.2e-3, scheme = { spectral_radius = 0.8 }, energy_guard = { gain = 1e9, loss = 1e9 } }
"#,
    );
    let simulation = ancf::Simulation::new(&model).unwrap();
    let mut series = ancf::record::Series::new();
    let summary = simulation.run(&mut series).unwrap();
    let at = |owner: &str, row: usize| {
        let [x, y, z] = ["x", "y", "z"].map(|name| series.column(&format!("{owner}.{name}")).unwrap()[row]);
        Vector3::new(x, y, z)
    };
    let rows = series.column("t").unwrap().len();
    for row in 0..rows {
        let [x, y, z] = ["x", "y", "z"].map(|owner| at(owner, row) - at("o", row));
        let volume = x.dot(&y.cross(&z));
        assert!((volume - 1.0).abs() < 1e-9, "row {row} of {rows}: {volume}");
    }
    // The steps are divided, or they fail at last.
    let is_failed = matches!(summary.outcome, Outcome::Failed { .. });
    assert!(is_failed || summary.divided_steps > 0, "{:?}", summary.outcome);
}

/// A torsion spring is released at once. Steps of the time constant of its damper make twice the energy of the spring in the
/// first step, directly after a start from rest, where the guard permits it.
#[test]
fn energy_made_at_a_start_from_rest_is_reported() {
    let warnings = |step: f64| {
        let run = Run::of(&parse(&format!(
            r#"
materials.m = {{ density = 1455, young = 1.285e7 }}
sections.s = {{ kind = "rectangle", height = 0.056, width = 0.054 }}
bodies = [{{ kind = "beam", name = "b", from = [0, 0, 0], to = [0.5, 0, 0], elements = 4, section = "s", material = "m", formulation = "linked" }}]
joints = [{{ kind = "revolute", name = "j", a = {{ body = "b", at = "start" }}, axis = [0.6, 0.8, 0], spring = {{ stiffness = 66.3, damping = 1.729, angle = -0.07 }} }}]
analysis = {{ kind = "dynamics", duration = 0.1, step = {step}, scheme = "adams", energy_guard = {{ loss = 1 }} }}
"#
        )));
        run.summary.warnings.join(" ")
    };
    let coarse = warnings(6e-3);
    assert!(coarse.contains("the integration has made"), "{coarse}");
    let fine = warnings(4e-4);
    assert!(!fine.contains("the integration has made"), "{fine}");
}

/// A beam at rest on a hinge with friction moves by its rounding errors. These are no energy that the integration makes.
#[test]
fn friction_at_rest_makes_no_energy() {
    for angles in [[0.0, 0.0, 0.0], [0.4, -1.2, 0.3], [2.0, 0.5, -0.9], [-0.3, 0.8, 1.7]] {
        let turned = Rotation3::from_euler_angles(angles[0], angles[1], angles[2]);
        let list = |x: [f64; 3]| format!("{:?}", <[f64; 3]>::from(turned * Vector3::from(x)));
        let run = Run::of(&parse(&format!(
            r#"
scales = {{ kind = "none" }}
materials.m = {{ density = 1455, young = 1.285e9, poisson = 0.3 }}
sections.s = {{ kind = "rectangle", height = 0.056, width = 0.054 }}
bodies = [{{ kind = "beam", name = "b", from = [0, 0, 0], to = {}, up = {}, twist = 0.7, elements = 4, section = "s", material = "m", formulation = "continuum" }}]
joints = [{{ kind = "revolute", name = "j", a = {{ body = "b", at = "start" }}, axis = {}, friction = {{ moment = 220, rate = 3 }} }}]
analysis = {{ kind = "dynamics", duration = 0.05, step = 1.8e-3, scheme = "adams", newton = "full" }}
"#,
            list([-0.82, 0.07, 0.14]),
            list([0.58, 0.63, 0.51]),
            list([0.0, -1.0, 0.0]),
        )));
        assert!(!run.summary.warnings.join(" ").contains("energy"), "{:?}", run.summary.warnings);
    }
}

/// Average acceleration does not damp the vibrations of a stiff beam that large steps do not resolve: the reactions alternate. The
/// program says so. Numerical damping, or steps that resolve a soft beam, need no warning.
#[test]
fn alternating_accelerations_are_warned_of() {
    let run = |scheme: &str, young: f64, step: f64| {
        Run::of(&parse(&format!(
            r#"
gravity = [0, -9.81, 0]
materials.m = {{ density = 1000, young = {young:e} }}
sections.s = {{ kind = "circle", diameter = 0.04 }}
bodies = [{{ kind = "beam", name = "b", from = [0, 0, 0], to = [0.8, 0, 0], elements = 2, section = "s", material = "m", motion = {{ spin = [0, 0, 2] }} }}]
joints = [{{ kind = "spherical", name = "j", a = {{ body = "b", at = "start" }} }}]
loads = [{{ kind = "force", on = {{ body = "b", at = "end" }}, force = [0, 1, 0] }}]
analysis = {{ kind = "dynamics", duration = {}, step = {step}, scheme = {scheme} }}
"#,
            40.0 * step
        )))
    };
    let is_warned = |run: &Run| run.summary.warnings.iter().any(|text| text.contains("alternate"));
    // Mean change of a reaction from step to step.
    let change = |run: &Run| {
        let late = &run.column("j.fx")[20..];
        late.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum::<f64>() / late.len() as f64
    };
    let (undamped, damped) =
        (run("\"average_acceleration\"", 1e9, 0.01), run("{ spectral_radius = 0.8 }", 1e9, 0.01));
    assert!(
        is_warned(&undamped),
        "{:?} {} {}",
        undamped.summary.warnings,
        change(&undamped),
        change(&damped)
    );
    assert!(change(&undamped) > 3.0 * change(&damped), "{} {}", change(&undamped), change(&damped));
    assert!(!is_warned(&damped));
    assert!(!is_warned(&run("\"average_acceleration\"", 1e5, 2e-4)));
}
