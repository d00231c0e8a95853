//! Comparison with the printed numbers that do not depend on the machine.

use serde::Serialize;

use super::forms::{Agreement, Equation34, FormValues, Table6};

/// Comparison with each printed table.
#[derive(Clone, Debug, Serialize)]
pub struct PaperVerdict {
    /// Comparisons.
    pub checks: Vec<PrintedCheck>,
}

/// Comparison with a group of printed numbers.
#[derive(Clone, Debug, Serialize)]
pub struct PrintedCheck {
    /// Place in the paper.
    pub what: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// Largest difference of a reproduced number.
    pub tolerance: f64,
    /// Numbers within the tolerance.
    pub within: usize,
    /// Compared numbers, exact numbers, largest difference.
    #[serde(flatten)]
    pub agreement: Agreement,
}

impl PaperVerdict {
    /// Compares all printed numbers except the analysis times.
    pub fn new(equation34: Equation34, table3: &FormValues, table5: &FormValues, table6: &Table6) -> Self {
        let single = |ours: f64, paper: f64| FormValues {
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
                PrintedCheck::new("Table 3, unit of time", "s", table3, 2, 0.005),
                PrintedCheck::new("Eq. (34), static deflection", "mm", &eq34, 3, 0.0005),
                PrintedCheck::new("Table 5, mean deflection", "mm", table5, 3, 2e-3),
                PrintedCheck::new("Table 6, step", "s", &steps, 5, 5e-6),
                PrintedCheck::new("Table 6, instants", "", &table6.instants, 0, 0.0),
            ],
        }
    }

    /// Returns the number of printed numbers.
    pub fn numbers(&self) -> usize {
        self.checks.iter().map(|check| check.agreement.numbers).sum()
    }

    /// Returns the number of printed numbers within their tolerance.
    pub fn within(&self) -> usize {
        self.checks.iter().map(|check| check.within).sum()
    }

    /// Returns the number of printed numbers that agree to the last digit.
    pub fn exact(&self) -> usize {
        self.checks.iter().map(|check| check.agreement.exact).sum()
    }
}

impl PrintedCheck {
    fn new(
        what: &'static str,
        unit: &'static str,
        table: &FormValues,
        decimals: usize,
        tolerance: f64,
    ) -> Self {
        // Half a unit of the last digit is allowed, including rounding.
        let allowed = tolerance * (1.0 + 1e-9);
        let within = table.pairs().filter(|(ours, printed)| (ours - printed).abs() <= allowed).count();
        let agreement = Agreement::new(table, decimals);
        Self { what, unit, tolerance, within, agreement }
    }
}
