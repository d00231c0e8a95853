//! Equilibria of driven mechanisms without forces.

use ancf::Model;
use ancf::solver::equations::{EquationsOfMotion, State};

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

/// Driven clamps of a section and of all gradients: the rate of the residual with the load factor is its derivative, also
/// where the prescribed rotation is not linear in the load factor.
#[test]
fn rate_of_prescribed_rotations_is_the_derivative() {
    for fix in ["section", "all"] {
        let text = format!(
            "materials.m = {{ density = 1000, young = 2e9 }}\nsections.s = {{ kind = \"circle\", diameter = 0.02 }}\n\
             bodies = [{{ kind = \"beam\", name = \"arm\", from = [0, 0, 0], to = [0.8, 0, 0], elements = 2, section = \"s\", material = \"m\" }}]\n\
             joints = [{{ kind = \"drive\", name = \"motor\", a = {{ body = \"arm\", at = \"start\" }}, axis = [0.6, 0, 0.8], \
             angle = 1.1, time = 1, fix = \"{fix}\" }}]\n\
             loads = [{{ kind = \"force\", on = {{ body = \"arm\", at = \"center\" }}, force = [1, 2, 3] }}]\nanalysis = {{ kind = \"statics\" }}\n"
        );
        let assembly = Model::parse(&text).unwrap().assemble().unwrap();
        let system = &assembly.system;
        let mut state = State { load: 0.7, ..assembly.rest() };
        state.lambda.iter_mut().enumerate().for_each(|(i, x)| *x = (i as f64).sin());
        let residual = |load: f64| {
            let mut r = vec![0.0; system.coordinates() + system.multipliers()];
            system.residual(&State { load, ..state.clone() }, &mut r);
            r
        };
        // Fourth order, with a rounding error of ε/h and an error of h⁴/30 of the fifth derivative.
        let h = 1e-3;
        let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|k| residual(0.7 + k * h));
        let force = system.load_force(&state);
        for (i, force) in force.into_iter().enumerate() {
            let rate = -force;
            let exact = (a[i] - 8.0 * b[i] + 8.0 * c[i] - d[i]) / (12.0 * h);
            assert!(
                (rate - exact).abs() < 1e-7 * exact.abs().max(1.0),
                "{fix}, equation {i}: {rate} instead of {exact}"
            );
        }
    }
}
