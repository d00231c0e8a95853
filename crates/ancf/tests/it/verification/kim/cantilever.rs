//! Kim et al. (2017), section 3.1: cantilever released from the straight state under its own weight.
//!
//! ```text
//!   |/|====================  L = 1 m, d = 0.02 m, E = 193 GPa, ρ = 8030 kg/m³, ν = 0
//!   |/|    | | | | | | |     g = 9.81 m/s²
//! ```
//!
//! Goal: means of table 5 within 0.002 mm, static limit of eq. (34), equal results in both forms.

use std::f64::consts::PI;

use super::forms::{non_dimensional, non_dimensional_step};
use crate::common::assertions::assert_near;
use crate::common::models::rod;
use crate::common::solutions::equilibrium;
use crate::common::solutions::{Run, distance};

/// Number of elements; mean tip deflection in mm over all instants, dimensional and non-dimensional.
const TABLE_5: [(u32, f64, f64); 6] = [
    (1, -1.357, -1.356),
    (2, -1.870, -1.872),
    (5, -2.014, -2.015),
    (10, -2.032, -2.032),
    (15, -2.036, -2.036),
    (20, -2.037, -2.037),
];

/// Mean tip deflection in mm.
fn mean_tip(run: &Run) -> f64 {
    let y = run.column("tip.y");
    1e3 * y.iter().sum::<f64>() / y.len() as f64
}

#[test]
fn means_of_table_5() {
    for (elements, dimensional, scaled) in TABLE_5 {
        let model = rod::cantilever(elements);
        let name = format!("{elements} elements");
        assert_near(&name, mean_tip(&Run::of(&model)), dimensional, 2e-3);
        let name = format!("{elements} elements, non-dimensional");
        assert_near(&name, mean_tip(&Run::of(&non_dimensional_step(model))), scaled, 2e-3);
    }
}

/// Means to four decimals by an independent implementation of the equations of the paper.
#[test]
fn means_of_an_independent_implementation() {
    for (elements, dimensional, scaled) in
        [(1, -1.3571, -1.3564), (2, -1.8704, -1.8729), (5, -2.0147, -2.0161)]
    {
        let model = rod::cantilever(elements);
        let name = format!("{elements} elements");
        assert_near(&name, mean_tip(&Run::of(&model)), dimensional, 1e-4);
        assert_near(&name, mean_tip(&Run::of(&non_dimensional_step(model))), scaled, 1e-4);
    }
}

/// Eq. (34): −ρAgL⁴/(8EI) = −2.040 mm. Deflections converge to it from above (shear locking, figure 5).
#[test]
fn static_limit_of_eq_34() {
    let (area, second) = (PI * 0.02_f64.powi(2) / 4.0, PI * 0.02_f64.powi(4) / 64.0);
    let limit = -8030.0 * area * rod::GRAVITY / (8.0 * 193e9 * second);
    assert_near("eq. (34) in mm", 1e3 * limit, -2.040, 1e-3);
    let tips = TABLE_5.map(|(elements, ..)| {
        let (assembly, state) = equilibrium(&rod::cantilever(elements), 1);
        assembly.probes[0].1.value(&state).y
    });
    assert!(tips.is_sorted_by(|a, b| a > b), "{tips:?}");
    assert!((tips[5] / limit - 1.0).abs() < 1e-3, "{} and {limit}", tips[5]);
}

/// Equal motion and iterations of both forms with the same physical step.
#[test]
fn cantilever_forms_agree() {
    for elements in [1, 5] {
        let model = rod::cantilever(elements);
        let [a, b] = [model.clone(), non_dimensional(model)].map(|model| Run::of(&model));
        assert!(distance(&a.vectors("tip."), &b.vectors("tip.")) < 1e-9);
        let (a, b) = (a.summary.iterations as f64, b.summary.iterations as f64);
        assert!((a / b - 1.0).abs() < 0.01, "{elements} elements: {a} and {b} iterations");
    }
}
