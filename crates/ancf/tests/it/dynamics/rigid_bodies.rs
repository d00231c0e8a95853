//! Rigid bodies and point masses, against closed forms.

use ancf::Model;
use nalgebra::Vector3;

use crate::common::assertions::assert_near;
use crate::common::models::parse;
use crate::common::solutions::Run;

const MASS: f64 = 2.522_698_900_832_604;

/// Slender rod of length 1, released from horizontal about its end.
fn pendulum(scales: &str, radius: f64, step: f64) -> Model {
    let j = MASS / 12.0;
    parse(&format!(
        r#"
gravity = [0, -9.81, 0]
scales = {{ kind = "{scales}" }}
bodies = [{{ kind = "rigid", name = "rod", center = [0.5, 0, 0], mass = {MASS}, inertia = [0, {j}, {j}] }}]
joints = [{{ kind = "revolute", name = "pin", a = {{ body = "rod", at = [0, 0, 0] }}, axis = [0, 0, 1] }}]
probes = [{{ name = "tip", on = {{ body = "rod", at = [1, 0, 0] }}, record = ["motion", "rotation"] }}]
analysis = {{ kind = "dynamics", duration = 2, step = {step}, scheme = {{ spectral_radius = {radius} }} }}
"#
    ))
}

/// Time, angle, angular velocity, tip and pin force by Jacobi's elliptic functions.
const EXACT: [[f64; 7]; 4] = [
    [0.25, 0.456636358736, 3.60230718411, 0.89754070788, -0.440931602063, -22.0364851365, 17.0127040129],
    [0.5, 1.66114841675, 5.41386699075, -0.0902292085737, -0.995921025945, 5.00367383999, 61.4158639048],
    [1.0, 3.13341804483, -0.490485531299, -0.999966588072, -0.00817451771708, 0.455160506513, 6.19063989624],
    [2.0, 0.0326973425726, 0.980872741859, 0.999465489518, -0.0326915166742, -1.81936491714, 6.24642866133],
];

/// Motion and pin force to second order in the step.
#[test]
fn compound_pendulum_has_its_motion_and_pin_force() {
    for scales in ["none", "auto"] {
        let run = Run::of(&pendulum(scales, 0.8, 5e-4));
        let column = |name: &str| run.column(name);
        for [t, angle, rate, x, y, fx, fy] in EXACT {
            let row = (t / 5e-4).round() as usize;
            let at = |name: &str| column(name)[row];
            let near = |what: &str, found: f64, exact: f64, tolerance: f64| {
                assert!((found - exact).abs() < tolerance, "{scales}: {what} at {t}: {found} for {exact}");
            };
            near("x", at("tip.x"), x, 2e-5);
            near("y", at("tip.y"), y, 2e-5);
            near("angular velocity", at("tip.wz"), -rate, 1e-4);
            near("e0", at("tip.e0"), (0.5 * angle).cos().abs(), 1e-5);
            near("fx", at("pin.fx"), fx, 5e-3);
            near("fy", at("pin.fy"), fy, 5e-3);
        }
    }
}

/// Energy without numerical damping, to second order in the step.
#[test]
fn compound_pendulum_conserves_energy() {
    let run = Run::of(&pendulum("auto", 1.0, 2e-4));
    let (balance, size) = (run.largest("balance"), run.largest("kinetic"));
    assert!(balance < 1e-6 * size, "{balance:e} of {size}");
}

/// Static reactions of a light cantilever with an eccentric mass and a suspended mass at its end.
#[test]
fn masses_on_a_cantilever_have_static_reactions() {
    let run = Run::of(&parse(
        r#"
gravity = [0, 0, -10]
materials.light = { density = 1e-3, young = 2e11, poisson = 0.3 }
sections.round = { kind = "circle", diameter = 0.1 }
bodies = [
  { kind = "beam", name = "arm", from = [0, 0, 0], to = [2, 0, 0], elements = 4, formulation = "linked", section = "round", material = "light" },
  { kind = "rigid", name = "head", center = [2, 0.5, 0], mass = 3, inertia = [0.1, 0.1, 0.1] },
  { kind = "mass", name = "bob", center = [2, -0.3, 0], mass = 1 },
]
joints = [
  { kind = "clamp", name = "root", a = { body = "arm", at = "start" } },
  { kind = "clamp", name = "neck", a = { body = "head", at = [2, 0, 0] }, b = { body = "arm", at = "end" } },
  { kind = "spherical", name = "bob", a = { body = "bob", at = "center" }, b = { body = "arm", at = "end", offset = [0, -0.3, 0] } },
]
analysis = { kind = "statics", stop = { rule = "energy", tolerance = 1e-10 } }
"#,
    ));
    let near = |name: &str, exact: f64, tolerance: f64| {
        assert_near(name, run.last(name), exact, tolerance);
    };
    near("root.fz", 40.0, 1e-3);
    // Displacements of 1e-4 change the lever arms by the same amount.
    near("root.mx", 3.0 * 10.0 * 0.5 - 10.0 * 0.3, 1e-2);
    near("root.my", -80.0, 1e-2);
    near("neck.fz", 30.0, 1e-9);
    near("neck.mx", 15.0, 1e-2);
    near("bob.fz", 10.0, 1e-9);
}

/// Free symmetric top: the axis precesses about the angular momentum L at the rate |L|/J_t.
///
/// After half a period the axis is mirrored at L; after a period it returns.
#[test]
fn free_top_precesses_about_its_angular_momentum() {
    let (transverse, axial, spin) = (2.0, 1.0, [0.5, 0.0, 3.0]);
    let momentum = Vector3::new(transverse * spin[0], 0.0, axial * spin[2]);
    let period = std::f64::consts::TAU * transverse / momentum.norm();
    let run = Run::of(&parse(&format!(
        r#"
bodies = [{{ kind = "rigid", name = "top", center = [0, 0, 0], mass = 3, inertia = [{transverse}, {transverse}, {axial}], motion = {{ spin = {spin:?}, velocity = [1, 0, -2] }} }}]
probes = [
  {{ name = "end", on = {{ body = "top", at = [0, 0, 1] }}, record = ["motion", "rotation"] }},
  {{ name = "middle", on = {{ body = "top", at = "center" }} }},
]
analysis = {{ kind = "dynamics", duration = {period}, step = {step}, scheme = {{ spectral_radius = 1.0 }} }}
"#,
        step = period / 4000.0
    )));
    let axis: Vec<_> = run.vectors("end.").iter().zip(run.vectors("middle.")).map(|(a, b)| a - b).collect();
    let about = momentum.normalize();
    let mirrored = about * (2.0 * about.z) - Vector3::z();
    assert!((axis[2000] - mirrored).norm() < 1e-5, "{:?}", axis[2000]);
    assert!((axis[4000] - Vector3::z()).norm() < 1e-5, "{:?}", axis[4000]);
    let [x, z] = ["middle.x", "middle.z"].map(|name| run.column(name)[4000]);
    assert!((x - period).abs() < 1e-12 && (z + 2.0 * period).abs() < 1e-12, "{x} {z}");
    let spins = run.vectors("end.w");
    // J ω in the frame of the axis is L.
    for (a, w) in axis.iter().zip(&spins) {
        let moved = w * transverse + a * ((axial - transverse) * a.dot(w));
        assert!((moved - momentum).norm() < 1e-4 * momentum.norm(), "{moved:?}");
    }
}
