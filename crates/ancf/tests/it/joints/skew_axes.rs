//! Joints in any direction: no equation is redundant in an open chain, and equilibria do not depend on the frame.

use ancf::model::Body;
use nalgebra::{Rotation3, Vector3};

use crate::common::models::parse;
use crate::common::random::Random;
use crate::common::solutions::Run;

/// Joints between a hub and an arm, with the axes x, y, z in a frame. All remaining motions are driven or sprung.
fn joints(v: &dyn Fn([f64; 3]) -> String) -> Vec<String> {
    let (x, y, z) = (v([1.0, 0.0, 0.0]), v([0.0, 1.0, 0.0]), v([0.0, 0.0, 1.0]));
    vec![
        format!("kind = \"revolute\", axis = {x}, drive = {{ angle = 0.3 }}"),
        format!("kind = \"revolute\", axis = {y}, spring = {{ stiffness = 300 }}"),
        format!(
            "kind = \"cylindrical\", axis = {z}, drive = {{ angle = -0.4 }}, feed = {{ displacement = 0.02 }}"
        ),
        format!("kind = \"prismatic\", axis = {x}, drive = {{ displacement = 0.03 }}"),
        "kind = \"clamp\"".to_owned(),
    ]
}

/// A hub on the ground, an arm at a joint, and a beam clamped to the arm with an offset.
fn chain(turn: &Rotation3<f64>, hub: usize, formulation: &str) -> ancf::Model {
    let v = |x: [f64; 3]| format!("{:?}", <[f64; 3]>::from(turn * Vector3::from(x)));
    let joint = &joints(&v)[hub];
    let (start, end, off) = (v([0.31, -0.1, 0.2]), v([0.9, -0.1, 0.2]), v([-0.13, -0.12, 0.11]));
    parse(&format!(
        "materials.m = {{ density = 1100, young = 4e8, poisson = 0.3 }}
        sections.s = {{ kind = \"circle\", diameter = 0.04 }}
        bodies = [
          {{ kind = \"rigid\", name = \"hub\", center = {}, mass = 3, inertia = [0.06, 0.06, 0.06] }},
          {{ kind = \"beam\", name = \"arm\", from = {start}, to = {end}, up = {}, elements = 2, formulation = \"{formulation}\", section = \"s\", material = \"m\" }},
        ]
        joints = [
          {{ name = \"root\", a = {{ body = \"hub\", at = {} }}, {joint} }},
          {{ kind = \"clamp\", name = \"weld\", a = {{ body = \"arm\", at = \"start\", offset = {off} }}, b = {{ body = \"hub\", at = {} }} }},
        ]
        loads = [{{ kind = \"force\", on = {{ body = \"arm\", at = \"end\" }}, force = {} }}]
        probes = [{{ name = \"tip\", on = {{ body = \"arm\", at = \"end\" }} }}]
        [analysis]
        kind = \"statics\"
        first = 0.25
        stop = {{ rule = \"energy\", tolerance = 1e-11 }}",
        v([0.0, -0.2216, 0.0]),
        v([0.0, 1.0, 0.0]),
        v([0.0; 3]),
        v([0.18, -0.22, 0.31]),
        v([0.7, -2.0, 1.4]),
    ))
}

#[test]
fn open_chains_have_no_redundant_equations() {
    let mut random = Random(1879);
    for case in 0..60 {
        let turn = if case == 0 { Rotation3::identity() } else { Rotation3::new(random.vector3() * 2.5) };
        for hub in 0..5 {
            let formulation = ["linked", "quadratic", "enhanced", "continuum"][case % 4];
            let redundant = chain(&turn, hub, formulation).diagnose().unwrap().redundant;
            assert!(redundant.is_empty(), "{case}, {hub}, {formulation}: {redundant:?}");
        }
    }
}

/// A rigid body with a driven cylindrical joint, whose rows of the axis have rounding errors in place of zeros.
#[test]
fn rounding_errors_of_rows_are_no_redundancy() {
    for axis in ["[-0.9129, 0.1347, -0.3853]", "[0.671, 0.236, 0.7029]", "[-0.6031, 0.7563, 0.2536]"] {
        let model = parse(&format!(
            "bodies = [{{ kind = \"rigid\", name = \"b\", center = [0, -0.2216, 0], mass = 3.25, inertia = [0.0624, 0.0562, 0.0416], products = [-0.0025, -0.0099, -0.0064] }}]
            joints = [{{ kind = \"cylindrical\", name = \"j\", a = {{ body = \"b\", at = [0, 0, 0] }}, axis = {axis}, drive = {{ angle = -0.6 }}, feed = {{ displacement = -0.1 }} }}]
            analysis = {{ kind = \"statics\" }}"
        ));
        assert!(model.diagnose().unwrap().redundant.is_empty(), "{axis}");
    }
}

#[test]
fn equilibria_do_not_depend_on_the_frame() {
    let mut random = Random(1905);
    for hub in 0..5 {
        let base = Run::of(&chain(&Rotation3::identity(), hub, "linked"));
        for _ in 0..3 {
            let turn = Rotation3::new(random.vector3() * 2.0);
            let model = chain(&turn, hub, "linked");
            assert!(model.bodies.iter().any(Body::is_flexible));
            let found = turn.inverse() * Run::of(&model).last_vector("tip.");
            let expected = base.last_vector("tip.");
            assert!((found - expected).norm() < 1e-7, "{hub}: {found} {expected}");
        }
    }
}
