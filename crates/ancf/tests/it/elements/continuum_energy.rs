//! Energies of the two-node continuum element against numerical integration over the volume.

use std::sync::Arc;

use ancf::mechanics::elements::{Beam24, Profile};
use ancf::mechanics::kinematics::BeamShape;
use ancf::model::{Material, Section};
use nalgebra::{DVector, Rotation3, Vector3};

use crate::common::continuum;
use crate::common::random::Random;
use crate::common::sample::{Sample, energy};

const LENGTH: f64 = 0.7;

/// Element with its reference coordinates.
struct Element {
    name: String,
    term: Beam24,
    reference: [Vector3<f64>; 8],
    slope: f64,
    section: Section,
    material: Material,
}

/// Returns one element for each combination of section, Poisson's ratio, slope length and frame.
fn elements(gravity: Vector3<f64>) -> Vec<Element> {
    let tilted = Rotation3::from_euler_angles(0.4, -1.1, 2.3);
    let mut elements = Vec::new();
    let sections = [
        Section::circle(0.3),
        Section::tube(0.3, 0.2),
        Section::rectangle(0.3, 0.2),
        Section::ellipse(0.2, 0.3),
    ];
    for section in sections {
        for poisson in [0.0, 0.3] {
            for slope in [1.0, LENGTH] {
                for rotation in [Rotation3::identity(), tilted] {
                    elements.push(element(section.clone(), poisson, slope, rotation, gravity));
                }
            }
        }
    }
    elements
}

fn element(section: Section, poisson: f64, slope: f64, r: Rotation3<f64>, gravity: Vector3<f64>) -> Element {
    let material = Material::elastic(2.0, 30.0, poisson);
    let shape = BeamShape { length: LENGTH, slope };
    let profile = Profile::new(shape, material.lame(), material.density, section.moments(), gravity);
    let frame = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| r * axis);
    let [x, y, z] = frame.map(|axis| axis * slope);
    Element {
        name: format!("{section:?}, nu = {poisson}, slope length {slope}, frame {:.1}", frame[0].transpose()),
        term: Beam24::new(0..24, frame, Arc::new(profile)),
        reference: [Vector3::zeros(), x, y, z, frame[0] * LENGTH, x, y, z],
        slope,
        section,
        material,
    }
}

/// Strain energy ½∫(λ tr² E + 2G E:E) dV, integrated by at least 125 points.
#[test]
fn strain_energy_is_that_of_the_continuum() {
    let mut random = Random(31);
    for Element { name, term, reference, slope, section, material, .. } in elements(Vector3::zeros()) {
        let lame = material.lame();
        for _ in 0..5 {
            let at = Sample::random(&term, &mut random);
            let e = std::array::from_fn(|k| reference[k] + at.q.fixed_rows::<3>(3 * k));
            let density = |x: [f64; 3]| {
                let gradients = continuum::shape_gradients(LENGTH, slope, x);
                let strain = continuum::green_strain(&continuum::deformation_gradient(&e, &gradients));
                0.5 * lame.lambda * strain.trace().powi(2) + lame.shear * strain.norm_squared()
            };
            let reference = continuum::integrate(LENGTH, section.clone(), density);
            let strain = energy(&term, &at).strain;
            assert!((strain / reference - 1.0).abs() < 1e-13, "{name}: {strain} and {reference}");
        }
    }
}

/// Kinetic energy ½∫ρ v·v dV and potential energy −∫ρ g·u dV.
#[test]
fn kinetic_and_potential_energy_are_those_of_the_continuum() {
    let (mut random, gravity) = (Random(18), Vector3::new(0.3, -2.0, 0.7));
    for Element { name, term, slope, section, material, .. } in elements(gravity) {
        let at = Sample::random(&term, &mut random);
        let field = |nodes: &DVector<f64>, x| -> Vector3<f64> {
            let values = continuum::shape_values(LENGTH, slope, x);
            values.iter().enumerate().map(|(k, s)| nodes.fixed_rows::<3>(3 * k) * *s).sum()
        };
        let kinetic = |x| 0.5 * material.density * field(&at.v, x).norm_squared();
        let potential = |x| -at.local().load * material.density * gravity.dot(&field(&at.q, x));
        let found = energy(&term, &at);
        let reference = continuum::integrate(LENGTH, section.clone(), kinetic);
        assert!((found.kinetic / reference - 1.0).abs() < 1e-13, "{name}: {} and {reference}", found.kinetic);
        let reference = continuum::integrate(LENGTH, section, potential);
        assert!((found.potential - reference).abs() < 1e-14, "{name}: {} and {reference}", found.potential);
    }
}
