//! Stops of hinges and guides, against closed forms.

use crate::common::models::jointed_body::STATICS;
use crate::common::models::parse;
use crate::common::solutions::Run;
use ancf::Model;

/// Mass of 2 that moves at 1.5 against a stop at 0.1.
fn impact(damping: f64, analysis: &str) -> Run {
    Run::of(&parse(&format!(
        r#"
bodies = [{{ kind = "rigid", name = "block", center = [0, 0, 0], mass = 2, inertia = [1, 1, 1], motion = {{ velocity = [1.5, 0, 0] }} }}]
[[joints]]
kind = "prismatic"
name = "guide"
a = {{ body = "block", at = "center" }}
axis = [1, 0, 0]
stops = {{ lower = -5, upper = 0.1, stiffness = 2e4, transition = 0.02, damping = {damping} }}
[analysis]
kind = "dynamics"
duration = 0.2
step = 2e-5
{analysis}
"#
    )))
}

/// Depth by the energy: m v²/2 = U(d), which is k d³/(6 δ) up to δ and k (d (d − δ)/2 + δ²/6) beyond.
#[test]
fn elastic_stop_returns_the_energy() {
    for scheme in ["scheme = \"average_acceleration\"", "scheme = \"energy\""] {
        let run = impact(0.0, scheme);
        let depth = run.largest("guide.displacement") - 0.1;
        let (k, delta) = (2e4, 0.02);
        let energy: f64 = 0.5 * k * depth * (depth - delta) + k * delta * delta / 6.0;
        assert!(depth > delta && (energy / 2.25 - 1.0).abs() < 1e-4, "{scheme}: {energy}");
        assert!((run.last("guide.speed") / 1.5 + 1.0).abs() < 1e-5, "{scheme}: {}", run.last("guide.speed"));
        let bound = if scheme.contains("energy") { 1e-7 } else { 5e-3 };
        assert!(run.largest("balance") < bound, "{scheme}: {}", run.largest("balance"));
    }
}

/// ∫ v dv/h is the same for both parts of an impact: G(w) + c w³/3 = G(v) − c v³/3.
#[test]
fn damped_stop_has_the_restitution_of_its_law() {
    for damping in [0.1, 1.0] {
        let run = impact(damping, "scheme = \"average_acceleration\"");
        let g = |v: f64| ((1.0 + (damping * v).powi(2)).powf(1.5) - 1.0) / (3.0 * damping * damping);
        let (v, w) = (1.5, -run.last("guide.speed"));
        let [before, after] = [g(v) - damping * v.powi(3) / 3.0, g(w) + damping * w.powi(3) / 3.0];
        assert!((after / before - 1.0).abs() < 1e-4, "{damping}: {after} for {before}, speed {w}");
        let loss = 0.5 * 2.0 * (v * v - w * w);
        assert!((run.largest("dissipated") / loss - 1.0).abs() < 1e-3, "{}", run.largest("dissipated"));
    }
}

/// A moment against the stop of a hinge: M = k (d − δ/2).
#[test]
fn stop_of_a_hinge_bears_a_moment() {
    let text = |stops: &str| {
        format!(
            r#"
bodies = [{{ kind = "rigid", name = "arm", center = [0, 0, 0], mass = 1, inertia = [1, 1, 1] }}]
joints = [{{ kind = "revolute", name = "hinge", a = {{ body = "arm", at = "center" }}, axis = [0, 0, 1], spring = {{ stiffness = 10 }}, stops = {stops} }}]
loads = [{{ kind = "moment", on = {{ body = "arm", at = "center" }}, moment = [0, 0, 40] }}]
{STATICS}"#
        )
    };
    let angle =
        Run::of(&parse(&text("{ upper = 1.2, stiffness = 1e3, transition = 1e-3 }"))).last("hinge.angle");
    // 10 θ + 1000 (θ − 1.2 − 0.0005) = 40.
    let expected = (40.0 + 1e3 * 1.2005) / 1010.0;
    assert!((angle - expected).abs() < 1e-9, "{angle} for {expected}");
    let error = |stops: &str| Model::parse(&text(stops)).unwrap_err().to_string();
    assert!(error("{ stiffness = 1e3, transition = 1e-3 }").contains("neither `lower` nor `upper`"));
    let error = error("{ lower = 0.1, stiffness = 1e3, transition = 1e-3 }");
    assert!(error.contains("joints[0].stops.lower") && error.contains("at most 0"), "{error}");
}
