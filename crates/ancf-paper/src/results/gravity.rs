//! The acceleration of gravity, which the paper does not print.

use serde::Serialize;

use super::{Forms, area, second_moment};
use crate::paper::cases::{DENSITY, DURATION, GRAVITY, LENGTH, STEP, YOUNG};
use crate::paper::published;
use crate::paper::study::{STANDARD_GRAVITY, Study};

/// What the printed numbers say about g.
#[derive(Clone, Debug, Serialize)]
pub struct Gravity {
    /// The value that all runs use, m/s².
    pub recovered: f64,
    /// Values of g for which the non-dimensional form of Table 6 has the printed number of instants, m/s².
    pub interval: [f64; 2],
    /// Candidates.
    pub candidates: Vec<Candidate>,
    /// Table 5 with the usual 9.81 m/s², mm.
    pub table5_with_981: Forms,
    /// How Table 5 agrees with the recovered g.
    pub agreement: Agreement,
    /// How Table 5 agrees with 9.81 m/s².
    pub agreement_with_981: Agreement,
}

/// A value of g and what it leads to.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Candidate {
    /// g, m/s².
    pub g: f64,
    /// Instants of Table 6, non-dimensional form.
    pub instants: u64,
    /// Eq. (34), mm.
    pub static_deflection: f64,
}

/// How many numbers agree to the last printed digit, and by how much the worst is off.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Agreement {
    /// Numbers that agree to the last digit.
    pub exact: usize,
    /// Numbers compared.
    pub numbers: usize,
    /// Largest difference, in the unit of the table.
    pub worst: f64,
}

impl Gravity {
    /// Compares the recovered value with the usual ones.
    pub fn new(study: &Study, table5: &Forms) -> Self {
        let [dim, nondim] =
            [0, 1].map(|i| study.mean_with_standard_gravity.iter().map(|pair| pair[i]).collect());
        let table5_with_981 = Forms { dim, nondim, ..table5.clone() };
        Self {
            recovered: GRAVITY,
            interval: interval(published::TABLE_6_INSTANTS[1]),
            candidates: [GRAVITY, 9.806_65, STANDARD_GRAVITY].map(Candidate::new).to_vec(),
            agreement: Agreement::new(table5, 3),
            agreement_with_981: Agreement::new(&table5_with_981, 3),
            table5_with_981,
        }
    }
}

impl Candidate {
    fn new(g: f64) -> Self {
        let steps = (DURATION / (STEP * (LENGTH / g).sqrt())).floor();
        Self { g, instants: steps as u64 + 1, static_deflection: static_deflection(g) }
    }
}

impl Agreement {
    /// Compares a table with the printed one of so many decimals.
    pub fn new(table: &Forms, decimals: usize) -> Self {
        let pairs: Vec<_> = table.pairs().collect();
        let text = |x: f64| format!("{x:.decimals$}");
        Self {
            exact: pairs.iter().filter(|(ours, printed)| text(*ours) == text(*printed)).count(),
            numbers: pairs.len(),
            worst: pairs.iter().map(|(ours, printed)| (ours - printed).abs()).fold(0.0, f64::max),
        }
    }
}

impl Forms {
    /// Each number beside the printed one, where there is one.
    pub fn pairs(&self) -> impl Iterator<Item = (f64, f64)> {
        let dim = self.dim.iter().zip(self.paper_dim.iter().flatten());
        let nondim = self.nondim.iter().zip(self.paper_nondim.iter().flatten());
        dim.chain(nondim).map(|(&ours, &printed)| (ours, printed))
    }
}

/// The half-open interval of g for which 2 s hold so many instants of 0.001 √(L/g).
fn interval(instants: u64) -> [f64; 2] {
    let g = |steps: u64| LENGTH * (steps as f64 * STEP / DURATION).powi(2);
    [g(instants - 1), g(instants)]
}

/// δ = −q L⁴/(8 E I), q = ρ A g: eq. (34), mm.
pub fn static_deflection(g: f64) -> f64 {
    -1e3 * DENSITY * area() * g * LENGTH.powi(4) / (8.0 * YOUNG * second_moment())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Table 6 prints 6263 instants and eq. (34) -2.040 mm: only the recovered g gives both.
    #[test]
    fn printed_numbers_tell_g() {
        let told = [GRAVITY, 9.806_65, 9.81]
            .map(Candidate::new)
            .map(|c| (c.instants, format!("{:.3}", c.static_deflection)));
        assert_eq!(
            told,
            [(6263, "-2.040"), (6264, "-2.040"), (6265, "-2.041")].map(|(n, d)| (n, d.to_owned()))
        );
        let [low, high] = interval(6263);
        assert!(low < GRAVITY && GRAVITY < high && high < 9.806_65);
    }
}
