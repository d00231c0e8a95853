//! Functions of time with a kink or a jump at the end of a motion.

use crate::common::assertions::assert_relative;
use crate::common::models::parse;
use crate::common::solutions::Run;

/// Velocity and kinetic energy at the end of a mass on a spring, on a ground that begins to rotate by a ramp up to the end.
fn end_of_ramp(step: &str) -> [f64; 2] {
    let text = format!(
        r#"
        bodies = [{{ kind = "mass", name = "b", center = [1, 0, 0], mass = 1 }}]
        joints = [{{ kind = "spring", name = "s", a = {{ body = "b", at = "center" }}, b = {{ point = [0, 0, 0] }}, stiffness = 50 }}]
        loads = [{{ kind = "base_rotation", angular_velocity = [0, 0, 3], time = {{ kind = "ramp", end = 1 }} }}]
        probes = [{{ name = "p", on = {{ body = "b", at = "center" }} }}]
        analysis = {{ kind = "dynamics", duration = 1, step = {step} }}
        "#
    );
    let run = Run::of(&parse(&text));
    assert_eq!(run.last("t"), 1.0);
    ["p.vx", "kinetic"].map(|name| run.last(name))
}

/// The last step has the rate before the kink: errors are of second order in the step, as at kinks within the motion. The reference is
/// the extrapolation of both schemes to zero steps with a ramp that ends after the motion.
#[test]
fn kinks_at_the_end_keep_the_order() {
    let [coarse, fine] = ["5e-3", "2.5e-3"].map(end_of_ramp);
    let extrapolated = [0, 1].map(|i| fine[i] + (fine[i] - coarse[i]) / 3.0);
    assert_relative("velocity", extrapolated[0], -2.992_48, 1e-5);
    for (i, exact) in extrapolated.into_iter().enumerate() {
        let errors = [coarse[i], fine[i]].map(|value| (value - exact).abs() / exact.abs());
        assert!(errors[0] < 1e-4, "{errors:?}");
    }
    let [controlled, _] = end_of_ramp("{ tolerance = 1e-5 }");
    assert_relative("controlled steps", controlled, extrapolated[0], 1e-4);
}

/// A jump of a force at the end of a motion changes the acceleration of the last row, not its velocity.
#[test]
fn jumps_at_the_end_have_no_impulse() {
    let text = r#"
        bodies = [{ kind = "mass", name = "b", center = [0, 0, 0], mass = 2 }]
        loads = [{ kind = "force", on = { body = "b", at = "center" }, force = [6, 0, 0], time = { kind = "step", at = 1 } }]
        probes = [{ name = "p", on = { body = "b", at = "center" } }]
        analysis = { kind = "dynamics", duration = 1, step = 0.1 }
    "#;
    let run = Run::of(&parse(text));
    assert_eq!(["t", "p.vx", "p.ax"].map(|name| run.last(name)), [1.0, 0.0, 3.0]);
}
