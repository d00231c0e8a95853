//! Computed quantities of both forms beside the printed ones.

use serde::Serialize;

use crate::cases::{CaseRuns, TimedRun};

/// Eq. (34), mm.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Equation34 {
    /// With the recovered g.
    pub value: f64,
    /// As printed.
    pub paper: f64,
}

/// Quantity of both forms for each number of elements.
#[derive(Clone, Debug, Serialize)]
pub struct FormValues {
    /// Numbers of elements.
    pub n: Vec<u32>,
    /// Dimensional form.
    pub dim: Vec<f64>,
    /// Non-dimensional form.
    pub nondim: Vec<f64>,
    /// Dimensional form as printed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub paper_dim: Option<Vec<f64>>,
    /// Non-dimensional form as printed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub paper_nondim: Option<Vec<f64>>,
}

impl FormValues {
    /// Evaluates a quantity of runs.
    pub fn new(runs: &[CaseRuns], quantity: impl Fn(&TimedRun) -> f64) -> Self {
        Self {
            n: runs.iter().map(|c| c.n).collect(),
            dim: runs.iter().map(|c| quantity(&c.dim)).collect(),
            nondim: runs.iter().map(|c| quantity(&c.nondim)).collect(),
            paper_dim: None,
            paper_nondim: None,
        }
    }

    /// Adds the printed values.
    #[must_use]
    pub fn with_printed(self, dim: &[f64], nondim: &[f64]) -> Self {
        Self { paper_dim: Some(dim.to_vec()), paper_nondim: Some(nondim.to_vec()), ..self }
    }

    /// Returns pairs of computed and printed numbers.
    pub fn pairs(&self) -> impl Iterator<Item = (f64, f64)> {
        let dim = self.dim.iter().zip(self.paper_dim.iter().flatten());
        let nondim = self.nondim.iter().zip(self.paper_nondim.iter().flatten());
        dim.chain(nondim).map(|(&ours, &printed)| (ours, printed))
    }

    /// Returns the ratios DIM / Non-DIM.
    pub fn ratios(&self) -> Vec<f64> {
        self.dim.iter().zip(&self.nondim).map(|(dim, nondim)| dim / nondim).collect()
    }
}

/// Table 6. `dim` and `nondim` of the first part are numbers of instants.
#[derive(Clone, Debug, Serialize)]
pub struct Table6 {
    /// Instants.
    #[serde(flatten)]
    pub instants: FormValues,
    /// Physical step, s: dimensional, non-dimensional.
    #[serde(flatten)]
    pub step: StepSizes,
    /// Analysis time, s.
    #[serde(flatten)]
    pub seconds: AnalysisTimes,
}

/// Physical step of both forms, s.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct StepSizes {
    /// Dimensional form.
    pub step_dim: f64,
    /// Non-dimensional form.
    pub step_nondim: f64,
    /// Dimensional form as printed.
    pub paper_step_dim: f64,
    /// Non-dimensional form as printed.
    pub paper_step_nondim: f64,
}

/// Analysis time of both forms, s.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct AnalysisTimes {
    /// Dimensional form.
    pub seconds_dim: f64,
    /// Non-dimensional form.
    pub seconds_nondim: f64,
    /// Dimensional form as printed.
    pub paper_seconds_dim: f64,
    /// Non-dimensional form as printed.
    pub paper_seconds_nondim: f64,
}

/// Table 7 of section 3.3.
#[derive(Clone, Debug, Serialize)]
pub struct Table7 {
    /// Times, s.
    #[serde(flatten)]
    pub seconds: FormValues,
    /// Ratios DIM / Non-DIM.
    pub ratio: Vec<f64>,
    /// Statement of the paper.
    pub note: &'static str,
}

/// Agreement of computed numbers with printed ones.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Agreement {
    /// Numbers that agree to the last printed digit.
    pub exact: usize,
    /// Numbers compared.
    pub numbers: usize,
    /// Largest difference, in the unit of the table.
    pub worst: f64,
}

impl Agreement {
    /// Compares a table with the printed one, which has `decimals` decimals.
    pub fn new(table: &FormValues, decimals: usize) -> Self {
        let pairs: Vec<_> = table.pairs().collect();
        let text = |x: f64| format!("{x:.decimals$}");
        Self {
            exact: pairs.iter().filter(|(ours, printed)| text(*ours) == text(*printed)).count(),
            numbers: pairs.len(),
            worst: pairs.iter().map(|(ours, printed)| (ours - printed).abs()).fold(0.0, f64::max),
        }
    }
}
