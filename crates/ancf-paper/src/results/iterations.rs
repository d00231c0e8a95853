//! Newton iterations per step under different stopping rules.

use serde::Serialize;

use crate::cases::{IterationCounts, PaperRuns, TimedRun, ToleranceRuns};

/// Name of the default stopping rule in tables.
pub const UNIT_BLIND: &str = "unit-blind";

/// Figure 7: iterations per step of the revolute pendulum of one element.
#[derive(Clone, Debug, Serialize)]
pub struct Figure7 {
    /// Number of elements.
    pub n: [u32; 1],
    /// Bound on |r|₂ in the units of each form.
    pub tolerance: f64,
    /// Time at which the dimensional form stalled, s.
    pub stalled_at: Option<f64>,
    /// Iterations under that absolute tolerance.
    #[serde(flatten)]
    pub absolute: StepCounts,
    /// Iterations under the unit-blind rule.
    pub unit_blind: StepCounts,
}

/// Iterations per step.
#[derive(Clone, Debug, Serialize)]
pub struct StepCounts {
    /// Time of each step, s, dimensional form.
    pub t_dim: Vec<f64>,
    /// Iterations, dimensional form.
    pub dim: Vec<u32>,
    /// Time of each step, s, non-dimensional form.
    pub t_nondim: Vec<f64>,
    /// Iterations, non-dimensional form.
    pub nondim: Vec<u32>,
}

impl StepCounts {
    fn new(dim: IterationCounts, nondim: IterationCounts) -> Self {
        Self { t_dim: dim.t, dim: dim.iterations, t_nondim: nondim.t, nondim: nondim.iterations }
    }
}

impl Figure7 {
    /// Selects the absolute tolerance with the most iterations of the dimensional form, and the unit-blind rule.
    pub fn new(runs: &PaperRuns) -> Self {
        let largest = runs.tolerances.iter().max_by_key(|tolerance| tolerance.dim.max());
        let (tolerance, dim, nondim) = largest.map_or_else(
            || (f64::NAN, IterationCounts::default(), IterationCounts::default()),
            |ToleranceRuns { tolerance, dim, nondim }| (*tolerance, dim.clone(), nondim.clone()),
        );
        let counts = |run: &TimedRun| IterationCounts::of(&run.series, None);
        Self {
            n: [runs.revolute.n],
            tolerance,
            stalled_at: dim.stalled_at,
            absolute: StepCounts::new(dim, nondim),
            unit_blind: StepCounts::new(counts(&runs.revolute.dim), counts(&runs.revolute.nondim)),
        }
    }
}

/// Iterations of both forms under one stopping rule.
#[derive(Clone, Debug, Serialize)]
pub struct ToleranceRow {
    /// Absolute tolerance, `None` for the unit-blind rule.
    pub tolerance: Option<f64>,
    /// Dimensional form.
    pub dim: IterationEffort,
    /// Non-dimensional form.
    pub nondim: IterationEffort,
}

/// Iterations of a run.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct IterationEffort {
    /// Maximum of a completed step.
    #[serde(rename = "most")]
    pub max: u32,
    /// Total of all completed steps.
    pub total: u64,
    /// Completed steps.
    pub steps: usize,
    /// Time of a step that did not converge, s, if any.
    pub stalled_at: Option<f64>,
}

impl IterationEffort {
    fn new(counts: &IterationCounts) -> Self {
        Self {
            max: counts.max(),
            total: counts.iterations.iter().copied().map(u64::from).sum(),
            steps: counts.iterations.len(),
            stalled_at: counts.stalled_at,
        }
    }
}

/// Returns the iterations under absolute tolerances, largest first, then under the unit-blind rule.
pub fn tolerances(runs: &PaperRuns) -> Vec<ToleranceRow> {
    let row = |tolerance, dim: &IterationCounts, nondim: &IterationCounts| ToleranceRow {
        tolerance,
        dim: IterationEffort::new(dim),
        nondim: IterationEffort::new(nondim),
    };
    let absolute = runs.tolerances.iter().map(|t| row(Some(t.tolerance), &t.dim, &t.nondim));
    let [dim, nondim] =
        [&runs.revolute.dim, &runs.revolute.nondim].map(|run| IterationCounts::of(&run.series, None));
    absolute.chain([row(None, &dim, &nondim)]).collect()
}
