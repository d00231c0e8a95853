//! Unit test of beam 3243 of Project Chrono (`UT_ANCFBeam_3243`), the same 24-coordinate element.
//!
//! One element, 1 × 0.1 × 0.1, ρ = 7850, E = 210e9, ν = 0.3, straight along x, 9.80665 along −z.
//!
//! Goal: mass and gravity to all printed digits. Stiffness in the reference state by closed forms, since Chrono has the
//! shear factor k = 10(1+ν)/(12+11ν) and this element k = 1.

use std::sync::Arc;

use ancf::mechanics::elements::{Beam24, Profile};
use ancf::mechanics::kinematics::BeamShape;
use ancf::model::{Material, Section};
use ancf::solver::equations::{LOCAL, Local, LocalMatrix, Term, Weights};
use nalgebra::Vector3;

use crate::common::assertions::assert_relative;

const AREA: f64 = 0.01;
const MATERIAL: Material = Material::elastic(7850.0, 210e9, 0.3);

fn profile() -> Profile<8> {
    let section = Section::rectangle(0.1, 0.1);
    let shape = BeamShape { length: 1.0, slope: 1.0 };
    let gravity = Vector3::new(0.0, 0.0, -9.80665);
    Profile::new(shape, MATERIAL.lame(), MATERIAL.density, section.moments(), gravity)
}

fn element() -> Beam24 {
    let frame = [Vector3::x(), Vector3::y(), Vector3::z()];
    Beam24::new(0..24, frame, Arc::new(profile()))
}

const REST: Local<'_> = Local { q: &[0.0; 24], v: &[0.0; 24], a: &[0.0; 24], lambda: &[], t: 0.0, load: 1.0 };

/// Asserts nine digits.
#[track_caller]
fn assert_digits(what: &str, value: f64, reference: f64) {
    assert_relative(what, value, reference, 1e-9);
}

/// V1: rows and columns r, r_x, r_y, r_z of both nodes. Closed form: ρl (13A/35, 11Al/210, Al²/105, ..), ρlI/3, ρlI/6.
#[test]
fn mass_equals_chrono() {
    let (m11, m12, m15, m16) = (29.1571428571429, 4.11190476190476, 10.0928571428571, -2.4297619047619);
    let (m22, m26, m33, m37) =
        (0.747619047619048, -0.560714285714286, 0.0218055555555556, 0.0109027777777778);
    let mut expected = [[0.0; 8]; 8];
    let entries = [
        (0, 0, m11),
        (0, 1, m12),
        (0, 4, m15),
        (0, 5, m16),
        (1, 1, m22),
        (1, 4, -m16),
        (1, 5, m26),
        (4, 4, m11),
        (4, 5, -m12),
        (5, 5, m22),
        (2, 2, m33),
        (2, 6, m37),
        (6, 6, m33),
        (3, 3, m33),
        (3, 7, m37),
        (7, 7, m33),
    ];
    for (i, j, value) in entries {
        (expected[i][j], expected[j][i]) = (value, value);
    }
    for (i, (row, expected)) in profile().mass().iter().zip(expected).enumerate() {
        for (j, (&value, expected)) in row.iter().zip(expected).enumerate() {
            if expected == 0.0 {
                assert!(value.abs() < 1e-15, "M{i}{j} = {value}");
            } else {
                assert_digits(&format!("M{i}{j}"), value, expected);
            }
        }
    }
}

/// V2: the residual at rest is minus the force of gravity.
#[test]
fn gravity_equals_chrono() {
    let mut r = [0.0; 24];
    element().residual(&REST, &mut r);
    let expected = [(2, -384.9110125), (5, -64.1518354166667), (14, -384.9110125), (17, 64.1518354166667)];
    for (at, force) in expected {
        assert_digits(&format!("coordinate {at}"), -r[at], force);
        r[at] = 0.0;
    }
    assert_eq!(r, [0.0; 24]);
}

/// V4 with k = 1, from the energy of linear elasticity with S₁' = −6(ξ − ξ²)/l, S₂' = 1 − 4ξ + 3ξ², S₃ = y(1 − ξ).
#[test]
fn stiffness_equals_chrono() {
    let mut storage = [0.0; LOCAL * LOCAL];
    let mut k = LocalMatrix::zero(24, &mut storage);
    element().tangent(&REST, Weights::STIFFNESS, &mut k);
    let lame = MATERIAL.lame();
    let (axial, shear, lambda) =
        ((lame.lambda + 2.0 * lame.shear) * AREA, lame.shear * AREA, lame.lambda * AREA);
    let expected = [
        (0, 0, 1.2 * axial), // ∫ S₁'²
        (1, 1, 1.2 * shear),
        (2, 2, 1.2 * shear),
        (3, 0, axial / 10.0),       // ∫ S₁' S₂'
        (3, 3, axial * 2.0 / 15.0), // ∫ S₂'²
        (4, 1, shear / 10.0),
        (7, 0, -lambda / 2.0), // ∫ S₁' (1 − ξ) by λ, the y of r_y against the x of r
        (6, 1, -shear / 2.0),  // ∫ S₁' (1 − ξ) by G, the x of r_y against the y of r
    ];
    for (i, j, value) in expected {
        assert_digits(&format!("K{i}{j}"), k.get(i, j), value);
    }
    // Digits of Chrono for entries without k.
    for (i, j, printed) in [
        (0, 0, 3392307692.30769),
        (3, 0, 282692307.692308),
        (3, 3, 376923076.923077),
        (7, 0, -605769230.769231),
    ] {
        assert_digits(&format!("K{i}{j} as printed"), k.get(i, j), printed);
    }
    // Digits of Chrono for entries with k.
    let factor = 10.0 * 1.3 / (12.0 + 11.0 * 0.3);
    for (i, j, printed) in [(1, 1, 823529411.764706), (4, 1, 68627450.9803922), (6, 1, -343137254.901961)] {
        assert_digits(&format!("K{i}{j} as printed"), k.get(i, j) * factor, printed);
    }
}
