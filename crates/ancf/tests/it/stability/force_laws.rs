//! Modes of bodies on springs and force laws.

use ancf::record::Series;
use ancf::{Outcome, Summary, simulate};

use crate::common::assertions::assert_near;
use crate::common::models::parse;

/// A mass of 2 on a spring along x with a force law, and its modes.
fn on_a_law(law: &str, keys: &str) -> (Summary, Series) {
    let text = format!(
        r#"
        bodies = [{{ kind = "rigid", name = "w", center = [0, 0, 0], mass = 2, inertia = [0.1, 0.1, 0.1] }}]
        joints = [{{ kind = "prismatic", name = "p", a = {{ body = "w", at = "center" }}, axis = [1, 0, 0], {law} }}]
        analysis = {{ kind = "modes", count = 1{keys} }}
        "#
    );
    let mut series = Series::new();
    (simulate(&parse(&text), &mut series).unwrap(), series)
}

/// All modes of a model need no verification of their number.
#[test]
fn the_only_mode_has_no_warning() {
    let (summary, series) = on_a_law("spring = { stiffness = 50 }", "");
    assert!(summary.warnings.is_empty(), "{:?}", summary.warnings);
    assert_near("frequency", series.column("frequency").unwrap()[0], 5.0 / std::f64::consts::TAU, 1e-9);
}

/// At a kink of a force there is no stiffness: modes are rejected, damped or not. Smooth forces, also those with a large second
/// derivative, have modes.
#[test]
fn kinks_of_forces_are_rejected() {
    for keys in ["", ", damped = true"] {
        for formula in ["-50*max(x, 0)", "-50*min(x, 0)", "-if(x < 0, 100*x, 50*x)", "-50*x - 20*abs(x)"] {
            let law = format!("force = {{ kind = \"expression\", text = \"{formula}\" }}");
            let (summary, _) = on_a_law(&law, keys);
            let Outcome::Failed { reason, .. } = summary.outcome else { panic!("{formula}{keys}") };
            assert!(reason.contains("not differentiable"), "{formula}{keys}: {reason}");
        }
        for formula in ["-50*x", "-50*x - 1e4*x^2", "-50*sin(x) - 1e6*x*abs(x)"] {
            let law = format!("force = {{ kind = \"expression\", text = \"{formula}\" }}");
            let (summary, series) = on_a_law(&law, keys);
            assert!(summary.outcome.is_finished(), "{formula}{keys}: {:?}", summary.outcome);
            assert_near(
                "frequency",
                series.column("frequency").unwrap()[0],
                5.0 / std::f64::consts::TAU,
                1e-6,
            );
        }
    }
}
