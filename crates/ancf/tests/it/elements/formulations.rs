//! Beam formulations against closed forms: exact cases and rates of convergence.

use ancf::Model;
use ancf::assembly::Assembly;
use ancf::mechanics::kinematics::VectorKind;
use ancf::model::{ClampedGradients, Formulation, GeneralSection, Load, Material, Section};
use ancf::solver::equations::{EquationsOfMotion, State};
use nalgebra::Vector3;

use crate::common::models::rod;
use crate::common::solutions::linear;

const RODS: [Formulation; 3] = [Formulation::Enhanced, Formulation::Linked, Formulation::Quadratic];

const SECTIONS: [Section; 3] = [
    Section::circle(0.02),
    Section::rectangle(0.03, 0.01),
    Section::General(GeneralSection {
        area: 3e-4,
        iy: 5e-9,
        iz: 8e-9,
        j: Some(6e-9),
        ky: 0.7,
        kz: 0.9,
        mass_iy: None,
        mass_iz: None,
    }),
];

/// Steel cantilever of 1 m without gravity.
fn cantilever(
    elements: u32,
    formulation: Formulation,
    section: Section,
    poisson: f64,
    fix: ClampedGradients,
) -> Model {
    let mut model = rod::clamped(elements, fix);
    model.gravity = [0.0; 3];
    rod::beam(&mut model).formulation = formulation;
    rod::material(&mut model).poisson = poisson;
    model.sections.insert("circle".into(), section);
    model
}

/// Adds a force at the tip.
fn with_tip_force(mut model: Model, force: [f64; 3]) -> Model {
    model.loads = vec![Load::force(rod::end(), force)];
    model
}

fn tip(assembly: &Assembly, state: &State) -> Vector3<f64> {
    assembly.probes[0].1.displacement(state)
}

/// Deflections along y and z, relative to PL³/3EI + PL/kGA.
fn deflections(elements: u32, formulation: Formulation, section: Section, fix: ClampedGradients) -> [f64; 2] {
    let poisson = 0.3;
    let model = cantilever(elements, formulation, section.clone(), poisson, fix);
    let (material, m) = (model.materials["steel"], section.moments());
    let [ky, kz] = section.shear_factors(poisson);
    let [along_y, along_z] = [(m.yy, ky), (m.zz, kz)].map(|(second, k)| {
        1.0 / (3.0 * material.young * second) + 1.0 / (k * material.lame().shear * m.area)
    });
    let assembly = with_tip_force(model, [0.0, 1.0, 1.0]).assemble().unwrap();
    let moved = tip(&assembly, &linear(&assembly, &[]));
    [moved.y / along_y, moved.z / along_z]
}

/// PL³/3EI + PL/kGA with EI and kGA instead of (λ+2G)I and GA. The enhanced element misses 1/(4n²) of the bending part.
#[test]
fn tip_deflection_is_exact_in_one_element() {
    for section in SECTIONS {
        for elements in [1, 2, 5] {
            for formulation in [Formulation::Linked, Formulation::Quadratic] {
                for part in deflections(elements, formulation, section.clone(), ClampedGradients::Section) {
                    assert!((part - 1.0).abs() < 1e-9, "{formulation:?}, {section:?}, {elements}: {part}");
                }
            }
            for part in
                deflections(elements, Formulation::Enhanced, section.clone(), ClampedGradients::Section)
            {
                let missing = (1.0 - part) * f64::from(4 * elements * elements);
                assert!((0.99..1.0).contains(&missing), "{section:?}, {elements}: {part}");
            }
        }
    }
}

/// A clamp of r_x suppresses the shear of the axis there: 1/2n of the shear deflection is missing.
#[test]
fn full_clamp_suppresses_shear_in_the_first_element() {
    for section in SECTIONS {
        let (m, material) = (section.moments(), Material::elastic(8030.0, 193e9, 0.3));
        let shear = 1.0 / (section.shear_factors(0.3)[0] * material.lame().shear * m.area);
        let share = shear / (shear + 1.0 / (3.0 * material.young * m.yy));
        for elements in [1, 2, 4, 8] {
            let part = deflections(elements, Formulation::Linked, section.clone(), ClampedGradients::All)[0];
            let expected = 1.0 - share / f64::from(2 * elements);
            assert!((part - expected).abs() < 1e-9, "{section:?}, {elements}: {part} and {expected}");
        }
    }
}

/// Rotation TL/GJ with St. Venant's J; half of the torque acts on r_y and half on r_z.
#[test]
fn torsion_angle_is_that_of_st_venant() {
    for section in SECTIONS {
        for formulation in RODS {
            for elements in [1, 3] {
                let model =
                    cantilever(elements, formulation, section.clone(), 0.3, ClampedGradients::Section);
                let exact =
                    rod::LENGTH / (model.materials["steel"].lame().shear * section.torsion_constant());
                let assembly = model.assemble().unwrap();
                let vectors: Vec<_> = assembly.mesh("rod").unwrap().vectors(&assembly.rest()).collect();
                let last = |kind| vectors.iter().rfind(|v| v.kind == kind).unwrap().first;
                let (y, z) = (last(VectorKind::Y) + 2, last(VectorKind::Z) + 1);
                let state = linear(&assembly, &[(y, 0.5), (z, -0.5)]);
                for turn in [state.q[y], -state.q[z]] {
                    let part = turn / exact;
                    assert!((part - 1.0).abs() < 1e-9, "{formulation:?}, {section:?}, {elements}: {part}");
                }
            }
        }
    }
}

/// Uniaxial stretch s with free contraction, c² = 1 − ν (s² − 1): axial force EA s (s² − 1)/2, with E instead of λ+2G.
///
/// All other nodal forces vanish.
#[test]
fn tension_with_free_contraction_has_modulus_e() {
    for formulation in RODS {
        for (poisson, stretch) in [(0.0, 1.1), (0.3, 1.1), (0.45, 0.8), (-0.3, 1.3)] {
            let mut model =
                cantilever(3, formulation, Section::circle(0.02), poisson, ClampedGradients::Section);
            model.joints.clear();
            let assembly = model.assemble().unwrap();
            let (system, mut state) = (&assembly.system, assembly.rest());
            let contraction = (1.0 - poisson * (stretch * stretch - 1.0_f64)).sqrt();
            let mesh = assembly.mesh("rod").unwrap();
            for vector in mesh.vectors(&assembly.rest()) {
                let size = match vector.kind {
                    VectorKind::Position | VectorKind::Slope | VectorKind::Twist => stretch,
                    VectorKind::Y | VectorKind::Z => contraction,
                };
                for axis in 0..3 {
                    state.q[vector.first + axis] = vector.value[axis] * (size - 1.0);
                }
            }
            let mut forces = vec![0.0; system.coordinates()];
            system.residual(&state, &mut forces);
            let rigidity = model.materials["steel"].young * model.sections["circle"].moments().area;
            let force = rigidity * stretch * (stretch * stretch - 1.0) / 2.0;
            for vector in mesh.vectors(&assembly.rest()) {
                for axis in 0..3 {
                    let end = vector.kind == VectorKind::Position && axis == 0;
                    let expected = match vector.value.x {
                        x if end && x == 0.0 => -force,
                        x if end && x == rod::LENGTH => force,
                        _ => 0.0,
                    };
                    let error = (forces[vector.first + axis] - expected).abs();
                    assert!(error < 1e-12 * rigidity, "{formulation:?}, nu = {poisson}: {vector:?}, {error}");
                }
            }
        }
    }
}

/// Relative error of the linear tip deflection under own weight, qL⁴/8EI + qL²/2kGA.
fn own_weight(elements: u32, formulation: Formulation) -> f64 {
    let section = Section::circle(0.02);
    let poisson = if formulation == Formulation::Continuum { 0.0 } else { 0.3 };
    let mut model = cantilever(elements, formulation, section.clone(), poisson, ClampedGradients::Section);
    model.gravity = [0.0, -rod::GRAVITY, 0.0];
    let (material, m) = (model.materials["steel"], section.moments());
    let k = if formulation == Formulation::Continuum { 1.0 } else { section.shear_factors(poisson)[0] };
    let exact = 1.0 / (8.0 * material.young * m.yy) + 1.0 / (2.0 * k * material.lame().shear * m.area);
    let assembly = model.assemble().unwrap();
    let load = material.density * m.area * rod::GRAVITY;
    tip(&assembly, &linear(&assembly, &[])).y / (-load * exact) - 1.0
}

/// Elements with shear locking miss 1/(3n²) of the bending part. The others are exact at the nodes, with EI for ν = 0.3.
#[test]
fn own_weight_deflection_is_exact_or_of_second_order() {
    for elements in [1, 2, 4, 8, 16] {
        for formulation in [Formulation::Continuum, Formulation::Enhanced] {
            let missing = -own_weight(elements, formulation) * f64::from(3 * elements * elements);
            assert!((0.999..1.0).contains(&missing), "{formulation:?}, {elements}: {missing}");
        }
        for formulation in [Formulation::Linked, Formulation::Quadratic] {
            let error = own_weight(elements, formulation);
            assert!(error.abs() < 1e-9, "{formulation:?}, {elements}: {error:e}");
        }
    }
}
