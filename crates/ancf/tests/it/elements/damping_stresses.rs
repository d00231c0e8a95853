//! Recorded stresses contain those of the damping: E (ε + τ dε/dt).

use ancf::mechanics::shells::{ShellMedium, ShellMesh, ShellSection, SurfaceStress};
use ancf::solver::equations::State;
use nalgebra::Vector3;

use super::shear_membranes::sheet;
use crate::common::assertions::{assert_near, assert_relative};
use crate::common::models::parse;
use crate::common::random::Random;
use crate::common::solutions::Run;
use crate::errors::shells::Shell::{Quadrilaterals, Thin, Triangles};

/// Sheet that creeps under a force F per width, almost without inertia: n = F/λ at any time, with the stretch λ.
#[test]
fn creeping_sheets_have_the_forces_of_equilibrium() {
    let laws = ["none", "{ law = \"neo_hookean\" }", "{ tension_field = true }"];
    for (kind, law) in
        [Thin, Quadrilaterals, Triangles].into_iter().flat_map(|kind| laws.map(|law| (kind, law)))
    {
        let force = 0.003;
        let text = sheet(kind, law, [force, 0.0], false)
            .replace("density = 1,", "density = 1e-9, damping = { strain = 0.05 },")
            .replace(
                "kind = \"statics\", stop = { rule = \"energy\", tolerance = 1e-20 }",
                "kind = \"dynamics\", duration = 0.02, step = 1e-3",
            );
        let run = Run::of(&parse(&text));
        let (what, stretch) = (format!("{kind:?}, {law}"), run.last("p.x"));
        assert!(stretch > 1.01 && stretch < 1.07, "{what}: {stretch} of about 1.1 at rest");
        assert_relative(&what, run.last("p.nuu"), force / stretch, 1e-3);
        assert_relative(&what, run.last("p.suu_middle"), force / stretch / 0.01, 1e-3);
        assert_near(&what, run.last("p.nvv"), 0.0, 1e-3 * force);
    }
}

/// Bar that is pulled at the rate ε̇ = 0.1/s: the stress times the stretch is the reaction per area, for all formulations.
#[test]
fn pulled_bars_have_the_stress_of_their_reaction() {
    for body in [
        "kind = \"beam\", formulation = \"continuum\"",
        "kind = \"beam\", formulation = \"enhanced\"",
        "kind = \"beam\", formulation = \"linked\"",
        "kind = \"beam\", formulation = \"quadratic\"",
        "kind = \"cable\"",
    ] {
        for damping in ["strain = 0.05", "stretch = 0.05, bending = 0.3"] {
            if body.contains("continuum") && damping.contains("stretch") {
                continue;
            }
            let run = Run::of(&parse(&format!(
                r#"
materials.m = {{ density = 1e-3, young = 5e6, poisson = 0, damping = {{ {damping} }} }}
sections.s = {{ kind = "rectangle", height = 0.02, width = 0.02 }}
bodies = [{{ {body}, name = "b", from = [0, 0, 0], to = [1, 0, 0], elements = 8, section = "s", material = "m" }}]
joints = [
  {{ kind = "clamp", name = "c", a = {{ body = "b", at = "start" }} }},
  {{ kind = "drive", name = "d", a = {{ body = "b", at = "end" }}, displacement = [1, 0, 0], time = {{ kind = "expression", text = "0.1*t^2/(t+0.01)" }} }},
]
probes = [{{ name = "p", on = {{ body = "b", at = 0.5 }}, record = ["stress", "strain"] }}]
analysis = {{ kind = "dynamics", duration = 0.5, step = 1e-2 }}
"#
            )));
            let strain = run.last("p.exx");
            let stretch = if body.contains("cable") { 1.0 } else { (1.0 + 2.0 * strain).sqrt() };
            let (stress, reaction) = (run.last("p.sxx"), run.last("d.fx") / 0.02_f64.powi(2));
            assert_relative(&format!("{body}, {damping}"), stress * stretch, reaction.abs(), 5e-3);
            assert!(stress > 1.05 * 5e6 * strain, "{body}: a tenth of the stress is that of the damping");
        }
    }
}

/// Cantilever that vibrates with damped bending and torsion: the stress at an edge is N/A + My z/I, with the moment of the damping.
#[test]
fn damped_bending_has_the_stress_of_its_moment() {
    for formulation in ["linked", "quadratic"] {
        let run = Run::of(&parse(&format!(
            r#"
materials.m = {{ density = 1000, young = 5e6, poisson = 0, damping = {{ strain = 1e-3, bending = 0.02, torsion = 0.04 }} }}
sections.s = {{ kind = "circle", diameter = 0.02 }}
bodies = [{{ kind = "beam", formulation = "{formulation}", name = "b", from = [0, 0, 0], to = [0.5, 0, 0], elements = 8, section = "s", material = "m" }}]
joints = [{{ kind = "clamp", name = "c", a = {{ body = "b", at = "start" }} }}]
loads = [
  {{ kind = "force", on = {{ body = "b", at = "end" }}, force = [0, 0, 1e-3] }},
  {{ kind = "moment", on = {{ body = "b", at = "end" }}, moment = [1e-4, 0, 0] }},
]
probes = [{{ name = "p", on = {{ body = "b", at = 0.25 }}, offset = [0, 0.01], record = ["stress", "section_forces"] }}]
analysis = {{ kind = "dynamics", duration = 0.06, step = 1e-3 }}
"#
        )));
        let (area, second) = (std::f64::consts::PI * 1e-4, std::f64::consts::PI * 1e-8 / 4.0);
        let expected = run.last("p.N") / area + run.last("p.My") * 0.01 / second;
        assert_relative(&format!("{formulation}: bending"), run.last("p.sxx"), expected, 0.03);
        // The torsional stress at z is −T z/J along y.
        let torsion = -run.last("p.T") * 0.01 / (2.0 * second);
        assert_relative(&format!("{formulation}: torsion"), run.last("p.sxy"), torsion, 0.03);
    }
}

/// Shell in a random state: the part of velocities in forces, moments and stresses is τ times the rate of the others.
#[test]
fn stresses_of_velocities_are_rates_of_stresses() {
    let time = 0.3;
    let mesh = |retardation: f64| {
        let section = ShellSection::isotropic(2e5, 0.3, 1.0, 0.05);
        let medium =
            ShellMedium { section, axis: None, retardation, mass_damping: 0.0, gravity: Vector3::zeros() };
        let map = |[u, v]: [f64; 2]| {
            let (sin, cos) = u.sin_cos();
            [
                Vector3::new(3.0 * cos, 3.0 * sin, 2.0 * v),
                Vector3::new(-3.0 * sin, 3.0 * cos, 0.0),
                Vector3::new(0.0, 0.0, 2.0),
                Vector3::zeros(),
            ]
        };
        ShellMesh::new(0, [3, 2], Vector3::zeros(), map, &medium)
    };
    let (damped, elastic, mut random) = (mesh(time), mesh(0.0), Random(5));
    let mut s = State::rest(damped.coordinates(), 0);
    s.q.iter_mut().for_each(|q| *q = 0.01 * random.number());
    s.v.iter_mut().for_each(|v| *v = random.number());
    let h = 1e-5;
    let moved = |sign: f64| {
        let mut moved = s.clone();
        moved.q.iter_mut().zip(&s.v).for_each(|(q, v)| *q += sign * h * v);
        moved
    };
    let numbers = |stress: SurfaceStress| -> Vec<f64> {
        let parts = [stress.force, stress.moment].into_iter().chain(stress.layers);
        parts.flat_map(|part| [part.x, part.y, part.z]).collect()
    };
    for at in [[0.1, 0.7], [0.5, 0.5], [1.0 / 3.0, 0.2]] {
        let [before, after] = [-1.0, 1.0].map(|sign| numbers(elastic.stress(&moved(sign), at)));
        let (own, still) = (numbers(damped.stress(&s, at)), numbers(elastic.stress(&s, at)));
        let size = own.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        for k in 0..own.len() {
            let rate = (after[k] - before[k]) / (2.0 * h);
            assert_near(&format!("{at:?}, {k}"), own[k] - still[k], time * rate, 1e-6 * size);
        }
    }
}
