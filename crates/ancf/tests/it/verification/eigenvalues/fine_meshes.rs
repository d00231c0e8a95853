//! Modes of meshes so fine that the rounding error of the assembled stiffness exceeds the lowest ω².
//!
//! Source: Euler's beam, βL of the cantilever and of the beam with free ends. A cable has neither shear nor rotary inertia, and the
//! error of its elements is below 10⁻¹² here.

use ancf::Model;
use ancf::model::{Body, Cable, ClampedGradients, Formulation, InitialMotion, Joint, Section, Slopes};
use ancf::solver::eigen::{EigenModes, modes};
use ancf::solver::newton::Interrupt;

use crate::common::assertions::assert_near;
use crate::common::models::rod;

const CANTILEVER: [f64; 5] = [
    1.875_104_068_711_961,
    4.694_091_132_974_175,
    7.854_757_438_237_613,
    10.995_540_734_875_467,
    14.137_168_391_046_47,
];
const FREE: [f64; 2] = [4.730_040_744_862_704, 7.853_204_624_095_838];

fn found(model: &Model, count: usize) -> EigenModes {
    let assembly = model.assemble().unwrap();
    modes(&assembly.system, assembly.system.matrix(), &assembly.rest(), count, &Interrupt::default()).unwrap()
}

/// Cable with the length of the rod in a direction.
fn cable(elements: u32, direction: [f64; 3], joints: Vec<Joint>) -> Model {
    let body = Body::Cable(Cable {
        name: "rod".into(),
        from: [0.0; 3],
        to: direction.map(|x| x * rod::LENGTH),
        up: None,
        elements,
        section: "circle".into(),
        material: "steel".into(),
        slopes: Slopes::Gradient,
        motion: InitialMotion::default(),
    });
    Model { bodies: vec![body], joints, gravity: [0.0; 3], ..rod::free(1) }
}

fn clamp() -> Vec<Joint> {
    rod::clamped(1, ClampedGradients::Section).joints
}

/// Angular frequencies, relative to √(EI/ρA)/L².
fn relative(model: &Model, found: &EigenModes) -> Vec<f64> {
    let (material, moments) = (model.materials["steel"], model.sections["circle"].moments());
    let unit = (material.young * moments.yy / (material.density * moments.area)).sqrt() / rod::LENGTH.powi(2);
    found.modes.iter().map(|mode| mode.omega_squared.sqrt() / unit).collect()
}

#[test]
fn cantilever_of_ten_thousand_elements_has_eulers_frequencies() {
    let model = cable(10_000, [1.0, 0.0, 0.0], clamp());
    let found = found(&model, 10);
    assert_eq!(found.rigid, 0);
    assert!(found.sturm.is_some());
    for (pair, beta) in relative(&model, &found).chunks(2).zip(CANTILEVER) {
        pair.iter().for_each(|omega| assert_near("a frequency", omega / beta.powi(2), 1.0, 1e-9));
    }
}

#[test]
fn frequencies_depend_on_neither_direction_nor_units() {
    let model = cable(3000, [0.36, 0.48, 0.8], clamp());
    let scales = ancf::Scales { length: 1e-3, time: 100.0, force: 1e5 };
    let scaled = found(&model.clone().scaled(&scales), 4);
    for (omega, scaled) in relative(&model, &found(&model, 4)).iter().zip(relative(&model, &scaled)) {
        assert_near("in other units", scaled / scales.time / omega, 1.0, 1e-9);
    }
    let omega = relative(&model, &found(&model, 4));
    assert_near("in an oblique direction", omega[3] / CANTILEVER[1].powi(2), 1.0, 1e-9);
}

/// A straight cable has no coordinate of its spin: five rigid motions.
#[test]
fn free_cable_has_its_rigid_motions_and_eulers_frequencies() {
    let model = cable(5000, [0.0, 0.6, 0.8], Vec::new());
    let found = found(&model, 9);
    assert_eq!(found.rigid, 5);
    let omega = relative(&model, &found);
    for (pair, beta) in omega[5..].chunks(2).zip(FREE) {
        pair.iter().for_each(|omega| assert_near("a frequency", omega / beta.powi(2), 1.0, 1e-9));
    }
}

/// Six rigid motions each, and square sections with pairs of equal frequencies of both beams.
#[test]
fn free_beams_have_six_rigid_motions_each() {
    let mut model = Model { gravity: [0.0; 3], ..rod::free(1000) };
    model.sections.insert("circle".into(), Section::rectangle(0.01, 0.01));
    rod::beam(&mut model).formulation = Formulation::Linked;
    let mut other = rod::beam(&mut model).clone();
    (other.name, other.from, other.to) = ("other".into(), [0.0, 1.0, 0.0], [0.0, 2.0, 0.0]);
    model.bodies.push(Body::Beam(other));
    let found = found(&model, 16);
    assert_eq!(found.rigid, 12);
    let omega = relative(&model, &found);
    for k in 13..16 {
        assert_near("four equal frequencies", omega[k] / omega[12], 1.0, 1e-9);
    }
    // Timoshenko's corrections are of the order of (r β)², r² = d²/12.
    assert_near("Euler's frequency", omega[12] / FREE[0].powi(2), 1.0, 1e-3);
}
