//! Acceleration of gravity, which the paper does not print.

use serde::Serialize;

use super::forms::{Agreement, FormValues};
use crate::cases::models::{DENSITY, DURATION, GRAVITY, LENGTH, STEP, YOUNG, area, second_moment};
use crate::cases::{PaperRuns, STANDARD_GRAVITY, published};

/// Consequences of the printed numbers for g.
#[derive(Clone, Debug, Serialize)]
pub struct GravityResults {
    /// Value of all runs, m/s².
    pub recovered: f64,
    /// Interval of g for which the non-dimensional form of Table 6 has the printed number of instants, m/s².
    pub interval: [f64; 2],
    /// Candidates.
    pub candidates: Vec<GravityCandidate>,
    /// Table 5 with 9.81 m/s², mm.
    pub table5_with_981: FormValues,
    /// Agreement of Table 5 with the recovered g.
    pub agreement: Agreement,
    /// Agreement of Table 5 with 9.81 m/s².
    pub agreement_with_981: Agreement,
}

/// Value of g and its consequences.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct GravityCandidate {
    /// g, m/s².
    pub g: f64,
    /// Instants of Table 6, non-dimensional form.
    pub instants: u64,
    /// Eq. (34), mm.
    pub static_deflection: f64,
}

impl GravityResults {
    /// Compares the recovered value with the usual ones.
    pub fn new(runs: &PaperRuns, table5: &FormValues) -> Self {
        let [dim, nondim] =
            [0, 1].map(|i| runs.mean_with_standard_gravity.iter().map(|pair| pair[i]).collect());
        let table5_with_981 = FormValues { dim, nondim, ..table5.clone() };
        Self {
            recovered: GRAVITY,
            interval: interval(published::TABLE_6_INSTANTS[1]),
            candidates: [GRAVITY, 9.806_65, STANDARD_GRAVITY].map(GravityCandidate::new).to_vec(),
            agreement: Agreement::new(table5, 3),
            agreement_with_981: Agreement::new(&table5_with_981, 3),
            table5_with_981,
        }
    }
}

impl GravityCandidate {
    fn new(g: f64) -> Self {
        let steps = (DURATION / (STEP * (LENGTH / g).sqrt())).floor();
        Self { g, instants: steps as u64 + 1, static_deflection: static_deflection(g) }
    }
}

/// Returns the half-open interval of g for which 2 s contain `instants` instants of 0.001 √(L/g).
fn interval(instants: u64) -> [f64; 2] {
    let g = |steps: u64| LENGTH * (steps as f64 * STEP / DURATION).powi(2);
    [g(instants - 1), g(instants)]
}

/// Returns the static deflection δ = −q L⁴/(8 E I), q = ρ A g: eq. (34), mm.
pub fn static_deflection(g: f64) -> f64 {
    -1e3 * DENSITY * area() * g * LENGTH.powi(4) / (8.0 * YOUNG * second_moment())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Table 6 prints 6263 instants and eq. (34) -2.040 mm. Only the recovered g gives both.
    #[test]
    fn printed_numbers_determine_g() {
        let computed = [GRAVITY, 9.806_65, 9.81]
            .map(GravityCandidate::new)
            .map(|c| (c.instants, format!("{:.3}", c.static_deflection)));
        assert_eq!(
            computed,
            [(6263, "-2.040"), (6264, "-2.040"), (6265, "-2.041")].map(|(n, d)| (n, d.to_owned()))
        );
        let [low, high] = interval(6263);
        assert!(low < GRAVITY && GRAVITY < high && high < 9.806_65);
    }
}
