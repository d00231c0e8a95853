//! Errors of the formulations in large rotations, against independent solutions of geometrically exact rods.
//!
//! The error that remains on fine meshes is of the order of (curvature × thickness)²: the Green strain of the fibres of a
//! curved axis differs from the strain of Reissner's rod.
#![expect(clippy::print_stdout, reason = "`--nocapture` prints the tables of decision 0011")]

use std::f64::consts::PI;

use ancf::Model;
use ancf::model::{ClampedGradients, Formulation, GeneralSection, Load, Section, Shape};
use nalgebra::Vector3;

use crate::common::models::rod;
use crate::common::solutions::equilibrium;

/// Cantilever without gravity under a force at its tip.
fn cantilever(
    elements: u32,
    formulation: Formulation,
    section: Section,
    poisson: f64,
    force: [f64; 3],
) -> Model {
    let mut model = rod::clamped(elements, ClampedGradients::Section);
    model.gravity = [0.0; 3];
    rod::beam(&mut model).formulation = formulation;
    rod::material(&mut model).poisson = poisson;
    model.sections.insert("circle".into(), section);
    model.loads = vec![Load::force(rod::end(), force)];
    model
}

fn tip(model: &Model, steps: u32) -> Vector3<f64> {
    let (assembly, state) = equilibrium(model, steps);
    assembly.probes[0].1.value(&state)
}

/// General section with the moments of area of another, kGA = EA/2 and the given J.
fn with_plain_shear(section: Section, poisson: f64, j: Option<f64>) -> Section {
    let (m, k) = (section.moments(), 1.0 + poisson);
    Section::General(GeneralSection {
        area: m.area,
        iy: m.zz,
        iz: m.yy,
        j,
        ky: k,
        kz: k,
        mass_iy: None,
        mass_iz: None,
    })
}

/// Tip position under a load P = α EI/L² along −y.
struct TipLoad {
    alpha: f64,
    /// Reissner's rod with kGA = EA/2 and L/d = 50 (shooting).
    rod: [f64; 2],
    /// Elastica by elliptic integrals (Bisshopp & Drucker 1945).
    elastica: [f64; 2],
}

const TIP_LOADS: [TipLoad; 3] = [
    TipLoad {
        alpha: 1.0,
        rod: [0.9435606328, -0.3017658497],
        elastica: [0.943566763716623, -0.301720773799814],
    },
    TipLoad {
        alpha: 5.0,
        rod: [0.6123490435, -0.7139529967],
        elastica: [0.61237163927557, -0.713791523611913],
    },
    TipLoad {
        alpha: 10.0,
        rod: [0.4449752850, -0.8109092306],
        elastica: [0.445004402246249, -0.810609024880296],
    },
];

/// Tip position of a rod of 1 m.
fn loaded_tip(
    elements: u32,
    formulation: Formulation,
    poisson: f64,
    diameter: f64,
    alpha: f64,
) -> Vector3<f64> {
    let circle = Section::circle(diameter);
    let force = -alpha * 193e9 * circle.moments().yy;
    let section =
        if formulation == Formulation::Continuum { circle } else { with_plain_shear(circle, poisson, None) };
    let steps = if diameter < 0.01 { 60 } else { 10 };
    tip(&cantilever(elements, formulation, section, poisson, [0.0, force, 0.0]), steps)
}

fn distance(a: Vector3<f64>, [x, y]: [f64; 2]) -> f64 {
    (a - Vector3::new(x, y, 0.0)).norm()
}

/// Error of the tip relative to L, for each load. Bounds are at most a fifth above the measured errors.
#[test]
fn tip_errors_are_bounded_for_thick_rods() {
    for (formulation, poisson, elements, bounds) in [
        (Formulation::Continuum, 0.0, 8, [8.9e-3, 6.9e-2, 9.0e-2]),
        (Formulation::Continuum, 0.0, 32, [9.8e-5, 3.8e-4, 5.6e-4]),
        (Formulation::Enhanced, 0.3, 8, [9.4e-3, 7.2e-2, 9.5e-2]),
        (Formulation::Enhanced, 0.3, 32, [9.5e-5, 3.4e-4, 5.2e-4]),
        (Formulation::Linked, 0.3, 2, [1.8e-3, 8.2e-2, 0.46]),
        (Formulation::Linked, 0.3, 4, [1.5e-4, 3.9e-3, 1.4e-2]),
        (Formulation::Linked, 0.3, 8, [4.6e-5, 6.2e-4, 1.2e-3]),
        (Formulation::Quadratic, 0.3, 2, [1.2e-4, 5.0e-3, 1.4e-2]),
        (Formulation::Quadratic, 0.3, 4, [1.7e-5, 4.0e-4, 1.1e-3]),
        (Formulation::Quadratic, 0.3, 8, [1.6e-5, 1.7e-4, 2.7e-4]),
    ] {
        for (load, bound) in TIP_LOADS.iter().zip(bounds) {
            let error = distance(loaded_tip(elements, formulation, poisson, 0.02, load.alpha), load.rod);
            println!("{formulation:?}, {elements} elements, {}: {error:.1e}", load.alpha);
            assert!(error < bound, "{formulation:?}, {elements} elements, {}: {error:e}", load.alpha);
        }
    }
}

/// L/d = 500: no membrane or thickness locking, fourth order, errors down to 10⁻⁵.
#[test]
fn tip_errors_are_bounded_for_slender_rods() {
    for (formulation, elements, bounds) in [
        (Formulation::Linked, 8, [7.7e-6, 2.0e-4, 6.0e-4]),
        (Formulation::Linked, 16, [1.4e-6, 1.8e-5, 4.5e-5]),
        (Formulation::Linked, 32, [1.0e-6, 7.0e-6, 1.2e-5]),
        (Formulation::Quadratic, 4, [7.2e-6, 2.9e-4, 9.2e-4]),
        (Formulation::Quadratic, 8, [1.1e-6, 2.0e-5, 5.6e-5]),
        (Formulation::Quadratic, 16, [7.0e-7, 4.0e-6, 8.0e-6]),
    ] {
        for (load, bound) in TIP_LOADS.iter().zip(bounds) {
            let error = distance(loaded_tip(elements, formulation, 0.3, 0.002, load.alpha), load.elastica);
            println!("{formulation:?}, {elements} elements, {}: {error:.1e}", load.alpha);
            assert!(error < bound, "{formulation:?}, {elements} elements, {}: {error:e}", load.alpha);
        }
    }
}

/// Changes of the tip by halving the thickness have the ratio 4.
#[test]
fn converged_error_is_of_second_order_in_the_thickness() {
    for formulation in [Formulation::Linked, Formulation::Quadratic] {
        let fine = |diameter| loaded_tip(32, formulation, 0.0, diameter, 5.0);
        let [thick, middle, thin] = [0.02, 0.01, 0.005].map(fine);
        let ratio = (thick - middle).norm() / (middle - thin).norm();
        assert!((ratio - 4.0).abs() < 0.2, "{formulation:?}: {ratio}");
    }
}

/// 45° bend of Bathe & Bolourchi (1979), a circular arc under a force normal to its plane; k = 1, ν = 0.
///
/// J is the polar moment or St. Venant's constant. Source: geometrically exact rod, converged (independent calculation).
#[test]
fn bend_of_45_degrees_converges_to_the_exact_rod() {
    let cases = [
        (1.0 / 6.0, 300.0, [58.7791224897, 22.2447809454, 40.1918916701]),
        (1.0 / 6.0, 600.0, [47.1504385736, 15.6848005340, 53.4748587918]),
        (0.140577, 600.0, [46.8919247814, 15.5577858240, 53.6073692657]),
    ];
    for (formulation, elements, bounds) in [
        (Formulation::Enhanced, 32, [3.3e-4, 5.6e-4, 6.0e-4]),
        (Formulation::Linked, 8, [2.0e-3, 3.6e-3, 4.3e-3]),
        (Formulation::Linked, 16, [5.5e-4, 1.0e-3, 1.2e-3]),
        (Formulation::Quadratic, 2, [5.3e-4, 3.0e-3, 2.5e-3]),
        (Formulation::Quadratic, 4, [4.4e-5, 2.0e-4, 1.5e-4]),
        (Formulation::Quadratic, 8, [5.2e-5, 1.2e-4, 1.2e-4]),
    ] {
        for ((torsion, load, limit), bound) in cases.into_iter().zip(bounds) {
            let section = with_plain_shear(Section::rectangle(1.0, 1.0), 0.0, Some(torsion));
            let mut model = cantilever(elements, formulation, section, 0.0, [0.0, 0.0, load]);
            rod::material(&mut model).young = 1e7;
            let (beam, half) = (rod::beam(&mut model), PI / 8.0);
            beam.to = [100.0 * (PI / 4.0).sin(), 100.0 * (1.0 - (PI / 4.0).cos()), 0.0];
            beam.shape = Shape::Arc { through: [100.0 * half.sin(), 100.0 * (1.0 - half.cos()), 0.0] };
            let error = (tip(&model, 10) - Vector3::from(limit)).norm() / (25.0 * PI);
            println!("{formulation:?}, {elements} elements, J = {torsion}, {load}: {error:.1e}");
            assert!(error < bound, "{formulation:?}, {elements} elements, J = {torsion}, {load}: {error:e}");
        }
    }
}

/// Princeton beam (Dowell & Traybar 1975) with the polar moment for J, bent about both axes and twisted.
///
/// Source: Reissner's rod, k = 1, ν = 0 (independent calculation).
#[test]
fn princeton_beam_converges_to_reissners_rod() {
    for (formulation, elements, bound) in [
        (Formulation::Linked, 4, 5.7e-5),
        (Formulation::Linked, 8, 1.7e-5),
        (Formulation::Quadratic, 2, 3.4e-5),
        (Formulation::Quadratic, 4, 2.3e-6),
    ] {
        let section = with_plain_shear(Section::rectangle(12.377e-3, 3.2024e-3), 0.0, None);
        let component = 8.896 / 2.0_f64.sqrt();
        let mut model = cantilever(elements, formulation, section, 0.0, [0.0, -component, component]);
        rod::beam(&mut model).to = [0.508, 0.0, 0.0];
        rod::material(&mut model).young = 71.7e9;
        let moved = tip(&model, 5) - Vector3::x() * 0.508;
        let error = (moved - Vector3::new(-0.0140523899, -0.0076267295, 0.1079407501)).norm() / 0.508;
        println!("{formulation:?}, {elements} elements: {error:.1e}");
        assert!(error < bound, "{formulation:?}, {elements} elements: {error:e}");
    }
}
