//! Closed forms of few elements: patch tests of tension, torsion and bending.
//!
//! ```text
//!   |/|==========o==========o==========> P, T
//!   |/|  | | | q = ρAg | | | | | | |
//! ```
//!
//! Source: independent calculation from the energy of the element in closed form. E (s³ − s)/2 A = P is the uniaxial law
//! of St. Venant-Kirchhoff for ν = 0.

use ancf::Model;
use ancf::model::{ClampedGradients, Load};
use ancf::solver::dynamics::consistent_accelerations;

use crate::common::assertions::assert_near;
use crate::common::models::rod;
use crate::common::solutions::equilibrium;
use crate::common::solutions::linear;

fn area(model: &Model) -> f64 {
    model.sections["circle"].moments().area
}

/// Rod without gravity under the tension P = `part` EA at its end.
fn pulled(elements: u32, fix: ClampedGradients, part: f64) -> Model {
    let mut model = rod::clamped(elements, fix);
    model.gravity = [0.0; 3];
    let force = part * model.materials["steel"].young * area(&model);
    model.loads = vec![Load::force(rod::end(), [force, 0.0, 0.0])];
    model
}

/// Uniform stretch s with s³ − s = 2P/EA, exact on any mesh.
#[test]
fn uniform_stretch_is_exact() {
    for (part, stretch) in [
        (0.001, 1.000998503986923),
        (0.01, 1.009853873369681),
        (0.1, 1.088033914691289),
        (0.5, 1.324717957244746),
    ] {
        for elements in [1, 3] {
            let (assembly, state) = equilibrium(&pulled(elements, ClampedGradients::Section, part), 1);
            let tip = assembly.probes[0].1.value(&state);
            assert_near(&format!("P = {part} EA"), tip.x / rod::LENGTH, stretch, 1e-10);
            assert_near("across", tip.y.hypot(tip.z), 0.0, 1e-10);
        }
    }
}

/// Elongation u EA/PL of the linear rod: 1 with free r_x at the clamp, smaller with fixed r_x.
#[test]
fn elongation_depends_on_the_clamped_slope() {
    let part = 1e-6;
    let elongation = |elements, fix| {
        let assembly = pulled(elements, fix, part).assemble().unwrap();
        assembly.probes[0].1.displacement(&linear(&assembly, &[])).x / (part * rod::LENGTH)
    };
    for (elements, fixed) in [
        (1, 8.0 / 9.0),
        (2, 0.9411764706),
        (4, 0.9705372617),
        (8, 0.9852686087),
        (16, 0.9926343044),
        (32, 0.9963171522),
    ] {
        assert_near("r_x free", elongation(elements, ClampedGradients::Section), 1.0, 1e-10);
        assert_near("r_x fixed", elongation(elements, ClampedGradients::All), fixed, 1e-9);
    }
}

/// φ = TL/(G I_p) for all meshes and Poisson ratios, without warping.
#[test]
fn torsion_is_exact_without_warping() {
    let torque = 0.1;
    for (elements, poisson) in [(1, 0.0), (1, 0.3), (3, 0.0), (3, 0.3)] {
        let mut model = rod::cantilever(elements);
        model.gravity = [0.0; 3];
        rod::material(&mut model).poisson = poisson;
        let moments = model.sections["circle"].moments();
        let polar = model.materials["steel"].lame().shear * (moments.yy + moments.zz);
        let assembly = model.assemble().unwrap();
        // A couple on r_y along z and on r_z along −y.
        let node = 12 * elements as usize;
        let state = linear(&assembly, &[(node + 8, 0.5 * torque), (node + 10, -0.5 * torque)]);
        let exact = torque * rod::LENGTH / polar;
        assert_near("rotation of r_y", state.q[node + 8] / exact, 1.0, 1e-9);
        assert_near("rotation of r_z", -state.q[node + 10] / exact, 1.0, 1e-9);
    }
}

/// Tip deflection under uniform load, ν = 0: coefficients of qL⁴/EI and qL²/GA.
#[test]
fn uniform_load_deflections_have_closed_forms() {
    let tip = |elements, fix, bending: f64, shear: f64| {
        let model = rod::clamped(elements, fix);
        let (material, moments) = (model.materials["steel"], model.sections["circle"].moments());
        let load = material.density * moments.area * rod::GRAVITY;
        let exact = -load * rod::LENGTH.powi(4) / (material.young * moments.yy) * bending
            - load * rod::LENGTH.powi(2) / (material.lame().shear * moments.area) * shear;
        let assembly = model.assemble().unwrap();
        let y = assembly.probes[0].1.displacement(&linear(&assembly, &[])).y;
        assert_near(&format!("{fix:?}, {elements} elements"), y / exact, 1.0, 1e-9);
    };
    tip(1, ClampedGradients::All, 1.0 / 12.0, 7.0 / 18.0);
    tip(2, ClampedGradients::All, 11.0 / 96.0, 15.0 / 34.0);
    tip(3, ClampedGradients::All, 13.0 / 108.0, 821.0 / 1782.0);
    for elements in [1, 2, 3, 4, 8] {
        let n = f64::from(elements);
        tip(elements, ClampedGradients::Section, (1.0 - 1.0 / (3.0 * n * n)) / 8.0, 0.5);
    }
}

/// One element released from horizontal about a pin: initial accelerations −15g/2l, −5g/4, −15g/4l of r_x(0), r(l), r_x(l)
/// along y, pin force mg/16 (rigid rod: −3g/2 at the tip, mg/4).
#[test]
fn release_about_a_pin_has_its_initial_accelerations() {
    for mut model in [rod::revolute(1), rod::spherical(1)] {
        let (length, g) = (0.8, rod::GRAVITY);
        model.gravity = [0.0, -g, 0.0];
        rod::beam(&mut model).to = [length, 0.0, 0.0];
        let weight = model.materials["steel"].density * area(&model) * length * g;
        let assembly = model.assemble().unwrap();
        let mut state = assembly.rest();
        consistent_accelerations(&assembly.system, &mut assembly.system.matrix(), &mut state).unwrap();
        for (at, exact) in [(4, -7.5 * g / length), (13, -1.25 * g), (16, -3.75 * g / length)] {
            assert_near(&format!("acceleration {at}"), state.a[at] / exact, 1.0, 1e-9);
        }
        let reaction = assembly.reactions(&state).next().unwrap().force;
        assert_near("reaction", reaction.y / (weight / 16.0), 1.0, 1e-9);
        assert_near("reaction along x and z", reaction.x.hypot(reaction.z), 0.0, 1e-9);
    }
}
