//! How the printed numbers that do not depend on the machine compare.

use serde::Serialize;

use super::gravity::Agreement;
use super::{Equation34, Forms, Table6};

/// One comparison for each printed table.
#[derive(Clone, Debug, Serialize)]
pub struct Verdict {
    /// The comparisons.
    pub checks: Vec<Check>,
}

/// A group of printed numbers.
#[derive(Clone, Debug, Serialize)]
pub struct Check {
    /// Where they are printed.
    pub what: &'static str,
    /// Their unit.
    pub unit: &'static str,
    /// Difference below which a number counts as reproduced.
    pub tolerance: f64,
    /// Numbers that are within the tolerance.
    pub within: usize,
    /// Numbers compared, agreement to the last digit, worst difference.
    #[serde(flatten)]
    pub agreement: Agreement,
}

impl Verdict {
    /// Compares everything that is printed and not a time of analysis.
    pub fn new(equation34: Equation34, table3: &Forms, table5: &Forms, table6: &Table6) -> Self {
        let single = |ours: f64, paper: f64| Forms {
            n: vec![1],
            dim: vec![ours],
            nondim: Vec::new(),
            paper_dim: Some(vec![paper]),
            paper_nondim: None,
        };
        let eq34 = single(equation34.value, equation34.paper);
        let mut steps = single(table6.step.step_dim, table6.step.paper_step_dim);
        steps.nondim = vec![table6.step.step_nondim];
        steps.paper_nondim = Some(vec![table6.step.paper_step_nondim]);
        Self {
            checks: vec![
                Check::new("Table 3, unit of time", "s", table3, 2, 0.005),
                Check::new("Eq. (34), static deflection", "mm", &eq34, 3, 0.0005),
                Check::new("Table 5, mean deflection", "mm", table5, 3, 2e-3),
                Check::new("Table 6, step", "s", &steps, 5, 5e-6),
                Check::new("Table 6, instants", "", &table6.instants, 0, 0.0),
            ],
        }
    }

    /// Printed numbers in all.
    pub fn numbers(&self) -> usize {
        self.checks.iter().map(|check| check.agreement.numbers).sum()
    }

    /// Those within their tolerance.
    pub fn within(&self) -> usize {
        self.checks.iter().map(|check| check.within).sum()
    }

    /// Those that agree to the last printed digit.
    pub fn exact(&self) -> usize {
        self.checks.iter().map(|check| check.agreement.exact).sum()
    }
}

impl Check {
    fn new(what: &'static str, unit: &'static str, table: &Forms, decimals: usize, tolerance: f64) -> Self {
        // Half a unit of the last digit is allowed to its end, rounding included.
        let allowed = tolerance * (1.0 + 1e-9);
        let within = table.pairs().filter(|(ours, printed)| (ours - printed).abs() <= allowed).count();
        let agreement = Agreement::new(table, decimals);
        Self { what, unit, tolerance, within, agreement }
    }
}
