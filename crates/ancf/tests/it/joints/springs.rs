//! Springs, ropes and bushings, against closed forms.

use ancf::record::Series;
use ancf::{Outcome, simulate};

use crate::common::models::jointed_body::{DYNAMICS, STATICS, jointed_body};
use crate::common::models::parse;
use crate::common::solutions::Run;

/// Damped vibration of a mass on a spring and damper, released 0.1 m from equilibrium.
#[test]
fn spring_and_damper_cause_a_damped_vibration() {
    let run = Run::of(&parse(&format!(
        r#"
bodies = [{{ kind = "mass", name = "bob", center = [1, 0, 0], mass = 2 }}]
joints = [{{ kind = "spring", name = "spring", a = {{ body = "bob", at = "center" }}, b = {{ point = [0, 0, 0] }}, stiffness = 200, damping = 4, length = 0.9 }}]
{DYNAMICS}"#
    )));
    let omega = (100.0_f64 - 1.0).sqrt();
    for (k, t) in run.column("t").iter().enumerate() {
        let (sin, cos) = (omega * t).sin_cos();
        let x = 0.1 * (-t).exp() * (cos + sin / omega);
        assert!((run.column("spring.length")[k] - 0.9 - x).abs() < 2e-5, "at {t}");
    }
    assert!(run.column("balance").iter().all(|x| x.abs() < 1e-3));
    assert!((run.column("spring.fx")[0] + 20.0).abs() < 1e-9);
}

/// Free fall until the rope is taut, then the force k (l − l₀); largest stretch by the energy.
#[test]
fn rope_acts_in_tension_only() {
    let run = Run::of(&parse(&format!(
        r#"
gravity = [0, 0, -10]
bodies = [{{ kind = "mass", name = "bob", center = [0, 0, -0.5], mass = 1 }}]
joints = [{{ kind = "spring", name = "rope", a = {{ body = "bob", at = "center" }}, b = {{ point = [0, 0, 0] }}, stiffness = 1e3, length = 1, tension_only = true }}]
{DYNAMICS}"#
    )));
    for (k, t) in run.column("t").iter().enumerate() {
        let (length, force) = (run.column("rope.length")[k], run.column("rope.fz")[k]);
        assert!((force - 1e3 * (length - 1.0).max(0.0)).abs() < 1e-6, "at {t}");
        if *t < 0.31 {
            assert!((length - 0.5 - 5.0 * t * t).abs() < 1e-5, "{length} at {t}");
        }
    }
    let longest = run.largest("rope.length");
    // ½ k x² = m g (0.5 + x).
    let stretch = (10.0 + (100.0_f64 + 2.0 * 1e3 * 5.0).sqrt()) / 1e3;
    assert!((longest - 1.0 - stretch).abs() < 2e-4, "{longest} for {}", 1.0 + stretch);
}

/// Displacement F/k; rotation M/k about each axis, which may be large.
#[test]
fn bushing_deflects_by_its_stiffness() {
    let loaded = |moment: [f64; 3]| {
        let keys =
            "kind = \"bushing\"\nstiffness = [100, 200, 300, 10, 20, 30]\ndamping = [1, 1, 1, 1, 1, 1]\n";
        let loads = format!(
            "[[loads]]\nkind = \"moment\"\non = {{ body = \"body\", at = \"center\" }}\nmoment = {moment:?}\n"
        );
        Run::of(&parse(&(jointed_body(keys) + &loads + STATICS)))
    };
    // Twist about x by more than half a turn; swing about y and z by more than a right angle.
    for (axis, moment, stiffness) in
        [(0, 38.0, 10.0), (0, -9.0, 10.0), (1, 33.0, 20.0), (2, 9.0, 30.0), (2, -70.0, 30.0)]
    {
        let mut vector = [0.0; 3];
        vector[axis] = moment;
        let turned = loaded(vector);
        let angle: f64 = moment / stiffness;
        let found = [turned.last("center.e0"), turned.last(["center.e1", "center.e2", "center.e3"][axis])];
        let sign = (0.5 * angle).cos().signum();
        let expected = [sign * (0.5 * angle).cos(), sign * (0.5 * angle).sin()];
        let error = (found[0] - expected[0]).abs() + (found[1] - expected[1]).abs();
        assert!(error < 1e-6, "axis {axis}, {moment}: {found:?} for {expected:?}");
        let reaction = turned.last(["joint.mx", "joint.my", "joint.mz"][axis]);
        assert!((reaction + moment).abs() < 1e-6, "axis {axis}, {moment}: {reaction}");
    }
    let keys = "kind = \"bushing\"\nstiffness = [100, 200, 300, 1e6, 1e6, 1e6]\n";
    let run = Run::of(&parse(&(String::from("gravity = [1, 2, 3]\n") + &jointed_body(keys) + STATICS)));
    for (axis, start, expected) in [("x", 0.4, 0.02), ("y", 0.1, 0.02), ("z", -0.2, 0.02)] {
        let moved = run.last(&format!("center.{axis}")) - start;
        assert!((moved - expected).abs() < 1e-4, "{axis}: {moved}");
    }
}

/// Rotation vectors and swings are unique below half a turn. A motion that passes it fails with any step, near this time.
#[test]
fn bushings_beyond_half_a_turn_fail() {
    let matrix = "kind = \"matrix_bushing\", stiffness = [[1e4, 0, 0], [0, 1e4, 0], [0, 0, 1e4]], rotation_stiffness = [[2, 0, 0], [0, 2, 0], [0, 0, 2]]";
    let swing = "kind = \"bushing\", stiffness = [1e4, 1e4, 1e4, 4, 2, 2]";
    for (joint, stiffness) in [(matrix, 2.0_f64), (swing, 2.0)] {
        for step in [1e-3, 5e-3] {
            let model = parse(&format!(
                r#"
                bodies = [{{ kind = "rigid", name = "b", center = [0, 0, 0], mass = 1, inertia = [1, 1, 1], motion = {{ spin = [0, 0, 8] }} }}]
                joints = [{{ {joint}, name = "m", a = {{ body = "b", at = [0, 0, 0] }} }}]
                probes = [{{ name = "p", on = {{ body = "b", at = "center" }}, record = ["rotation"] }}]
                analysis = {{ kind = "dynamics", duration = 1, step = {step:?}, scheme = {{ spectral_radius = 0.8 }} }}
                "#
            ));
            let mut series = Series::new();
            let Outcome::Failed { time, reason, .. } = simulate(&model, &mut series).unwrap().outcome else {
                panic!("{joint} passes half a turn")
            };
            // φ = 8/ω sin ωt.
            let omega = stiffness.sqrt();
            let half = (omega * std::f64::consts::PI / 8.0).asin() / omega;
            assert!(
                (time - half).abs() < 6e-3 && reason.contains("a joint is half a turn"),
                "{time}, {half}: {reason}"
            );
            let before = 8.0 * (omega * series.column("t").unwrap().last().unwrap()).cos();
            assert!((series.column("p.wz").unwrap().last().unwrap() - before).abs() < 1e-2);
        }
    }
}

/// The stiffness against tilting does not depend on the twist: a rotor on a bushing that is free about its axis keeps its sag
/// m g (1/k + l²/c) and its spin through more than a turn.
#[test]
fn bushing_carries_a_rotor_at_all_angles() {
    let run = Run::of(&parse(
        r#"
gravity = [0, 0, -10]
bodies = [{ kind = "rigid", name = "rotor", center = [0.12, 0, 0], mass = 1.5, inertia = [0.002, 0.001, 0.001], motion = { spin = [6, 0, 0] } }]
joints = [{ kind = "bushing", name = "mount", a = { body = "rotor", at = [0, 0, 0] }, stiffness = [1e5, 1e5, 1e5, 0, 2e3, 2e3], damping = [10, 10, 10, 0, 2, 2] }]
probes = [{ name = "c", on = { body = "rotor", at = "center" }, record = ["motion", "rotation"] }]
[analysis]
kind = "dynamics"
duration = 1.4
step = 1e-3
scheme = { spectral_radius = 0.8 }
"#,
    ));
    let sag = 15.0 * (1.0 / 1e5 + 0.12 * 0.12 / 2e3);
    for (t, (z, spin)) in run.column("t").iter().zip(run.column("c.z").iter().zip(run.column("c.wx"))) {
        assert!(z.abs() < 2.0 * sag && (spin - 6.0).abs() < 0.06, "{z}, {spin} at {t}");
        assert!(*t < 1.0 || (z + sag).abs() < 0.02 * sag, "{z} for {sag} at {t}");
    }
}

/// θ = 0.3 (1 − cos ωt) with ω² = k/J, for a torsion spring with the neutral angle 0.3.
#[test]
fn torsion_spring_oscillates_about_its_neutral_angle() {
    let run = Run::of(&parse(&format!(
        r#"
bodies = [{{ kind = "rigid", name = "disc", center = [0, 0, 0], mass = 1, inertia = [0.1, 0.1, 0.2] }}]
joints = [{{ kind = "revolute", name = "wire", a = {{ body = "disc", at = "center" }}, axis = [0, 0, 1], spring = {{ stiffness = 20, angle = 0.3 }} }}]
{DYNAMICS}"#
    )));
    for (k, t) in run.column("t").iter().enumerate() {
        let expected = 0.3 * (1.0 - (10.0 * t).cos());
        assert!((run.column("wire.angle")[k] - expected).abs() < 3e-4, "at {t}");
        let moment = -20.0 * (run.column("wire.angle")[k] - 0.3);
        assert!((run.column("wire.mz")[k] - moment).abs() < 1e-6, "at {t}");
    }
}

/// ω² = k/J from the spring of a joint coordinate.
#[test]
fn torsion_pendulum_has_its_natural_frequency() {
    let text = r#"
bodies = [{ kind = "rigid", name = "disc", center = [0, 0, 0], mass = 1, inertia = [0.1, 0.1, 0.2] }]
joints = [{ kind = "revolute", name = "wire", a = { body = "disc", at = "center" }, axis = [0, 0, 1], spring = { stiffness = 20 } }]
analysis = { kind = "modes", count = 1 }
"#;
    let run = Run::of(&parse(text));
    assert!((run.column("squared")[0] - 100.0).abs() < 1e-6, "{:?}", run.column("squared"));
}
