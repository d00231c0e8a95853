//! Vibrations about equilibria that are stable by their loads only.

use std::f64::consts::PI;

use ancf::model::ScaleChoice;
use ancf::record::Series;
use ancf::{Model, Outcome, simulate};

use crate::common::models::parse;
use crate::common::solutions::Run;

/// Body of 1 kg and 0.01 kg m² with its centre 0.3 m from the origin.
fn bob(center: [f64; 3], joints: &str) -> Model {
    let text = format!(
        "gravity = [0, 0, -9.81]
        bodies = [{{ kind = \"rigid\", name = \"bob\", center = {center:?}, mass = 1, inertia = [0.01, 0.01, 0.01] }}]
        joints = [{joints}]
        probes = [{{ name = \"bob\", on = {{ body = \"bob\", at = \"center\" }} }}]
        analysis = {{ kind = \"modes\", count = 3, about = \"equilibrium\" }}"
    );
    parse(&text)
}

/// ω = √(m g a/(J + m a²)) from any initial position. With a spherical joint the spin is free and the analysis fails.
#[test]
fn pendulum_has_its_natural_frequency() {
    let exact = (9.81 * 0.3 / (0.01 + 0.3_f64.powi(2))).sqrt() / (2.0 * PI);
    let hinge =
        "kind = \"revolute\", name = \"hook\", a = { body = \"bob\", at = [0, 0, 0] }, axis = [0, 1, 0]";
    let ball = "kind = \"spherical\", name = \"ball\", a = { body = \"bob\", at = [0, 0, 0] }";
    for center in [[0.0, 0.0, -0.3], [0.18, 0.0, -0.24], [0.3, 0.0, 0.0]] {
        for scales in [ScaleChoice::None, ScaleChoice::Auto] {
            let model = |joint: &str| Model { scales, ..bob(center, &format!("{{ {joint} }}")) };
            let hinged = Run::of(&model(hinge));
            let found = hinged.column("frequency")[0];
            assert!((found / exact - 1.0).abs() < 1e-9, "{center:?}: {found} not {exact}");
            let summary = simulate(&model(ball), &mut Series::new()).unwrap();
            assert!(!summary.outcome.is_finished(), "{center:?}: the spin is free");
        }
    }
}

#[test]
fn falling_body_has_no_equilibrium() {
    let summary = simulate(&bob([0.0, 0.0, 0.0], ""), &mut Series::new()).unwrap();
    let Outcome::Failed { reason, at, .. } = summary.outcome else { panic!("{:?}", summary.outcome) };
    assert!(reason.contains("a motion is unsupported") && at.contains("translate along z"), "{reason} {at}");
}
