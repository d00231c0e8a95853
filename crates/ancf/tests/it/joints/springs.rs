//! Springs, ropes and bushings, against mechanics of the textbook.

use crate::common::models::held::{DYNAMICS, STATICS, body, model};
use crate::common::solutions::Run;

/// A mass on a spring and a damper, released from 0.1 beyond rest: a damped vibration.
#[test]
fn oscillator() {
    let run = Run::of(&model(&format!(
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

/// A rope draws up to its length and lets go below.
#[test]
fn rope() {
    let run = Run::of(&model(&format!(
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
    let longest = run.column("rope.length").iter().fold(0.0, |most: f64, x| most.max(*x));
    // ½ k x² = m g (0.5 + x).
    let stretch = (10.0 + (100.0_f64 + 2.0 * 1e3 * 5.0).sqrt()) / 1e3;
    assert!((longest - 1.0 - stretch).abs() < 2e-4, "{longest} for {}", 1.0 + stretch);
}

/// Forces and moments over stiffnesses; large moments turn by ½ sin 2φ.
#[test]
fn bushing() {
    let held = |moment: f64| {
        let keys =
            "kind = \"bushing\"\nstiffness = [100, 200, 300, 10, 20, 30]\ndamping = [1, 1, 1, 1, 1, 1]\n";
        let loads = format!(
            "[[loads]]\nkind = \"moment\"\non = {{ body = \"body\", at = \"center\" }}\nmoment = [0, 0, {moment}]\n"
        );
        Run::of(&model(&(body(keys) + &loads + STATICS)))
    };
    let turned = held(9.0);
    let half = *turned.column("center.e0").last().unwrap();
    let angle = 2.0 * half.acos();
    assert!((30.0 * 0.5 * (2.0 * angle).sin() - 9.0).abs() < 1e-6, "{angle}");
    assert!((turned.column("joint.mz").last().unwrap() + 9.0).abs() < 1e-6);
    let keys = "kind = \"bushing\"\nstiffness = [100, 200, 300, 1e6, 1e6, 1e6]\n";
    let run = Run::of(&model(&(String::from("gravity = [1, 2, 3]\n") + &body(keys) + STATICS)));
    for (axis, start, wanted) in [("x", 0.4, 0.02), ("y", 0.1, 0.02), ("z", -0.2, 0.02)] {
        let moved = run.column(&format!("center.{axis}")).last().unwrap() - start;
        assert!((moved - wanted).abs() < 1e-4, "{axis}: {moved}");
    }
}

/// A hinge with a torsion spring set to 0.3: θ = 0.3 (1 − cos ωt), ω² = k/J.
#[test]
fn torsion_pendulum() {
    let run = Run::of(&model(&format!(
        r#"
bodies = [{{ kind = "rigid", name = "disc", center = [0, 0, 0], mass = 1, inertia = [0.1, 0.1, 0.2] }}]
joints = [{{ kind = "revolute", name = "wire", a = {{ body = "disc", at = "center" }}, axis = [0, 0, 1], spring = {{ stiffness = 20, angle = 0.3 }} }}]
{DYNAMICS}"#
    )));
    for (k, t) in run.column("t").iter().enumerate() {
        let wanted = 0.3 * (1.0 - (10.0 * t).cos());
        assert!((run.column("wire.angle")[k] - wanted).abs() < 3e-4, "at {t}");
        let moment = -20.0 * (run.column("wire.angle")[k] - 0.3);
        assert!((run.column("wire.mz")[k] - moment).abs() < 1e-6, "at {t}");
    }
}

/// Natural frequencies of what joint coordinates spring.
#[test]
fn modes_of_a_torsion_pendulum() {
    let text = r#"
bodies = [{ kind = "rigid", name = "disc", center = [0, 0, 0], mass = 1, inertia = [0.1, 0.1, 0.2] }]
joints = [{ kind = "revolute", name = "wire", a = { body = "disc", at = "center" }, axis = [0, 0, 1], spring = { stiffness = 20 } }]
analysis = { kind = "modes", count = 1 }
"#;
    let run = Run::of(&model(text));
    assert!((run.column("squared")[0] - 100.0).abs() < 1e-6, "{:?}", run.column("squared"));
}
