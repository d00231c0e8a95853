//! Static tip deflections of the cantilever of Kim et al. (2017) under its own weight, and their limits.
//!
//! Source: independent implementation of the element with exact quadrature. Limits: Reissner's rod with shear coefficient
//! one (shooting); for ν > 0 with (λ+2G)I instead of EI, since the element locks.

use std::f64::consts::PI;

use ancf::Model;
use ancf::model::Section;

use crate::common::assertions::assert_near;
use crate::common::models::rod;
use crate::common::solutions::equilibrium;

/// Tip deflection in mm.
fn tip(model: &Model) -> f64 {
    let (assembly, state) = equilibrium(model, 1);
    1e3 * assembly.probes[0].1.value(&state).y
}

/// Tip in mm, ν = 0; the limit is −2.041186330.
#[test]
fn static_tips_converge_for_zero_poisson_ratio() {
    for (elements, reference) in [
        (1, -1.358336145),
        (2, -1.870012968),
        (3, -1.965314278),
        (4, -1.998567063),
        (5, -2.013926194),
        (8, -2.030541339),
        (10, -2.034372652),
        (15, -2.038156295),
        (16, -2.038522869),
        (20, -2.039480803),
        (32, -2.040519002),
        (40, -2.040758764),
    ] {
        assert_near(&format!("{elements} elements"), tip(&rod::cantilever(elements)), reference, 1e-7);
    }
}

/// Tip in mm, ν = 0.3; the limit is −1.516542299.
#[test]
fn static_tips_lock_for_poisson_ratio_0_3() {
    for (elements, reference) in [
        (1, -1.010246772),
        (2, -1.389787853),
        (5, -1.496290840),
        (10, -1.511473155),
        (20, -1.515269895),
        (40, -1.516220550),
    ] {
        let mut model = rod::cantilever(elements);
        rod::material(&mut model).poisson = 0.3;
        assert_near(&format!("{elements} elements"), tip(&model), reference, 1e-7);
    }
}

/// Square section of equal EI, s⁴/12 = πd⁴/64, computed with beam 3243 of Project Chrono.
///
/// Chrono has the shear factor k = 10/12: its tips are lower by (1/k − 1) c qL²/GA with c = 7/18, 15/34 and nearly 1/2.
#[test]
fn static_tips_of_a_square_section_equal_chrono() {
    let side = 0.02 * (12.0 * PI / 64.0).powf(0.25);
    let shear = 8030.0 * rod::GRAVITY * rod::LENGTH.powi(2) / (193e9 / 2.0);
    for (elements, c, measured) in [
        (1, 7.0 / 18.0, -1.32761),
        (2, 15.0 / 34.0, -1.82754),
        (5, 0.5, -1.96811),
        (10, 0.5, -1.98809),
        (20, 0.5, -1.99308),
        (100, 0.5, -1.99468),
    ] {
        let mut model = rod::cantilever(elements);
        model.sections.insert("circle".into(), Section::rectangle(side, side));
        let reference = measured + 1e3 * (12.0 / 10.0 - 1.0) * c * shear;
        assert_near(&format!("{elements} elements"), tip(&model), reference, 1e-5);
    }
}
