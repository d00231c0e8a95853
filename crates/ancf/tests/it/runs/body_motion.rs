//! Columns of mass centers, momenta and energies of bodies.

use std::f64::consts::PI;

use ancf::Model;

use crate::common::assertions::{assert_near, assert_relative};
use crate::common::models::parse;
use crate::common::solutions::{Run, recorded_momenta};
use crate::errors::shells::Shell::{Quadrilaterals, Thin, Triangles};

const GRAVITY: f64 = 9.81;
const BEAM: f64 = 1000.0 * 0.25 * PI * 0.1 * 0.1 * 2.0;

/// A soft beam on a hinge at the origin carries a rigid body and a cable with a mass, all released from the horizontal.
fn pendulum(scales: &str) -> Model {
    parse(&format!(
        r#"
gravity = [0, 0, -{GRAVITY}]
scales = {{ kind = "{scales}" }}
materials.soft = {{ density = 1000, young = 1e7, poisson = 0.3 }}
sections.round = {{ kind = "circle", diameter = 0.1 }}
bodies = [
  {{ kind = "beam", name = "arm", from = [0, 0, 0], to = [2, 0, 0], elements = 3, formulation = "linked", section = "round", material = "soft" }},
  {{ kind = "rigid", name = "head", center = [2.3, 0.2, 0], mass = 3, inertia = [0.1, 0.2, 0.25] }},
  {{ kind = "cable", name = "tail", from = [2, 0, 0], to = [3, 0, 0], elements = 3, section = "round", material = "soft" }},
  {{ kind = "mass", name = "bob", center = [3, 0, 0], mass = 1 }},
]
joints = [
  {{ kind = "revolute", name = "hinge", a = {{ body = "arm", at = "start" }}, axis = [0, 1, 0] }},
  {{ kind = "clamp", name = "neck", a = {{ body = "head", at = [2, 0, 0] }}, b = {{ body = "arm", at = "end" }} }},
  {{ kind = "spherical", name = "knot", a = {{ body = "tail", at = "start" }}, b = {{ body = "arm", at = "end" }} }},
  {{ kind = "spherical", name = "tip", a = {{ body = "bob", at = "center" }}, b = {{ body = "tail", at = "end" }} }},
]
analysis = {{ kind = "dynamics", duration = 0.2, step = 1e-3, scheme = {{ spectral_radius = 1 }} }}
output = {{ momentum = true }}
"#
    ))
}

/// Masses and centers in the reference state: 2 m and 1 m of the rod, each about its middle.
#[test]
fn mass_centers_are_those_of_the_bodies() {
    let run = Run::of(&pendulum("auto"));
    let at_start = |name: &str| run.column(name)[0];
    for (name, x, y) in [("arm", 1.0, 0.0), ("head", 2.3, 0.2), ("tail", 2.5, 0.0), ("bob", 3.0, 0.0)] {
        assert_near(name, at_start(&format!("{name}.cx")), x, 1e-9);
        assert_near(name, at_start(&format!("{name}.cy")), y, 1e-9);
    }
    let masses = [(BEAM, 1.0), (3.0, 2.3), (0.5 * BEAM, 2.5), (1.0, 3.0)];
    let (mass, moment) = masses.iter().fold((0.0, 0.0), |(m, mx), (own, x)| (m + own, mx + own * x));
    assert_relative("center of the model", at_start("cx"), moment / mass, 1e-9);
}

/// The momenta of the model are those of its mass matrix, the energies of the bodies add up to those of the model, in any scales.
#[test]
fn bodies_add_up_to_the_model() {
    for scales in ["none", "auto"] {
        let model = pendulum(scales);
        let (run, momenta) = (Run::of(&model), recorded_momenta(&pendulum("none")));
        let names = ["arm", "head", "tail", "bob"];
        for part in ["kinetic", "strain"] {
            for (row, total) in run.column(part).iter().enumerate() {
                let sum: f64 = names.iter().map(|name| run.column(&format!("{name}.{part}"))[row]).sum();
                assert_near(part, sum, *total, 1e-9 * run.largest(part));
            }
        }
        let (linear, angular) = (run.vectors("p"), run.vectors("l"));
        for (row, [p, l]) in momenta.iter().enumerate() {
            let error = (linear[row] - p).norm().max((angular[row] - l).norm());
            assert!(error < 1e-6 * (1.0 + l.norm()), "{scales}, row {row}: {error:e}");
        }
    }
}

/// The momentum is the mass times the velocity of the center. Its angular part about the hinge changes by the moment of the
/// weight.
#[test]
fn momentum_changes_by_the_forces() {
    let (run, h) = (Run::of(&pendulum("auto")), 1e-3);
    let (centers, linear, angular) = (run.vectors("c"), run.vectors("p"), run.vectors("l"));
    let mass = 1.5 * BEAM + 4.0;
    let (mut impulse, size) = (0.0, run.largest("px").max(run.largest("pz")));
    for row in 1..centers.len() {
        let mean = 0.5 * (linear[row] + linear[row - 1]);
        let rate = (centers[row] - centers[row - 1]) / h * mass;
        assert!((rate - mean).norm() < 1e-3 * size, "row {row}: {rate} for {mean}");
        // ∫ (c × m g)·e_y dt by the trapezoidal rule.
        impulse += 0.5 * h * mass * GRAVITY * (centers[row].x + centers[row - 1].x);
        assert_near("angular momentum", angular[row].y, impulse, 1e-5 * angular[row].norm() + 1e-9);
    }
}

/// A free plate spins about its centre of mass by default, for any kind and numbering of its mesh: there is no linear momentum, and the
/// kinetic energy is ½ m (a² + b²)/12 ω².
#[test]
fn plates_spin_about_their_centre() {
    for kind in [Thin, Quadrilaterals, Triangles] {
        let model = [
            "analysis = { kind = \"dynamics\", duration = 1e-4, step = 1e-4 }\noutput.momentum = true\n\
             materials.m = { density = 1000, young = 1e9, poisson = 0.3 }\n"
                .into(),
            kind.body_on([1.0; 2], [4; 2], 0.01, |[x, y]| [3.0 - y, x, 2.0]),
            "motion = { spin = [0, 0, 5] }\n".into(),
        ]
        .concat();
        let run = Run::of(&parse(&model));
        let momentum = run.vectors("p")[0].norm();
        assert!(momentum < 1e-10, "{kind:?}: {momentum}");
        assert_relative(&format!("{kind:?}"), run.column("kinetic")[0], 0.5 * 10.0 / 6.0 * 25.0, 0.01);
    }
}
