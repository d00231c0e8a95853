//! Equilibria of driven mechanisms without forces.

use ancf::Model;

use crate::common::solutions::Run;

/// A crank and an arm, each on a driven hinge, without weight: rotations by given angles. The energy of all increments is zero.
#[test]
fn drives_without_forces_reach_their_angles() {
    let (first, second) = (0.7_f64, -1.2_f64);
    let text = format!(
        r#"
        bodies = [
          {{ kind = "rigid", name = "crank", center = [0.3, 0, 0], mass = 2, inertia = [0.1, 0.2, 0.25] }},
          {{ kind = "rigid", name = "arm", center = [1.0, 0, 0], mass = 1, inertia = [0.1, 0.1, 0.15] }},
        ]
        joints = [
          {{ kind = "revolute", name = "base", a = {{ body = "crank", at = [0, 0, 0] }}, axis = [0, 0, 1], drive = {{ angle = {first} }} }},
          {{ kind = "revolute", name = "elbow", a = {{ body = "arm", at = [0.8, 0, 0] }}, b = {{ body = "crank", at = [0.8, 0, 0] }}, axis = [0, 0, 1], drive = {{ angle = {second} }} }},
        ]
        probes = [{{ name = "hand", on = {{ body = "arm", at = [1.5, 0, 0] }} }}]
        analysis = {{ kind = "statics" }}
        "#
    );
    let run = Run::of(&Model::parse(&text).unwrap());
    let sum = first + second;
    let exact = [0.8 * first.cos() + 0.7 * sum.cos(), 0.8 * first.sin() + 0.7 * sum.sin()];
    for (name, exact) in ["hand.x", "hand.y"].into_iter().zip(exact) {
        assert!((run.last(name) - exact).abs() < 1e-12, "{name}: {} instead of {exact}", run.last(name));
    }
}
