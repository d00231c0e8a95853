//! Newton iterations per step under different stopping rules.

use serde::Serialize;

use crate::paper::study::{Counts, Run, Study, Tolerance};

/// Name of the default stopping rule in tables.
pub const UNIT_BLIND: &str = "unit-blind";

/// Figure 7: iterations of each step of the revolute pendulum of one element.
#[derive(Clone, Debug, Serialize)]
pub struct Figure7 {
    /// Number of elements.
    pub n: [u32; 1],
    /// Bound on |r|₂ in the numbers of each form.
    pub tolerance: f64,
    /// Time at which the dimensional form stalled, s.
    pub stalled_at: Option<f64>,
    /// Under that absolute tolerance.
    #[serde(flatten)]
    pub absolute: StepCounts,
    /// Under the unit-blind rule.
    pub unit_blind: StepCounts,
}

/// Iterations of each step.
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
    fn new(dim: Counts, nondim: Counts) -> Self {
        Self { t_dim: dim.t, dim: dim.iterations, t_nondim: nondim.t, nondim: nondim.iterations }
    }
}

impl Figure7 {
    /// The absolute tolerance under which the dimensional form needs the most, and the unit-blind rule.
    pub fn new(study: &Study) -> Self {
        let most = study.tolerances.iter().max_by_key(|tolerance| tolerance.dim.most());
        let (tolerance, dim, nondim) = most.map_or_else(
            || (f64::NAN, Counts::default(), Counts::default()),
            |Tolerance { tolerance, dim, nondim }| (*tolerance, dim.clone(), nondim.clone()),
        );
        let counts = |run: &Run| Counts::of(&run.series, None);
        Self {
            n: [study.revolute.n],
            tolerance,
            stalled_at: dim.stalled_at,
            absolute: StepCounts::new(dim, nondim),
            unit_blind: StepCounts::new(counts(&study.revolute.dim), counts(&study.revolute.nondim)),
        }
    }
}

/// Iterations of both forms under one stopping rule.
#[derive(Clone, Debug, Serialize)]
pub struct ToleranceRow {
    /// Absolute tolerance, or none for the unit-blind rule.
    pub tolerance: Option<f64>,
    /// Dimensional form.
    pub dim: Effort,
    /// Non-dimensional form.
    pub nondim: Effort,
}

/// Iterations of a run.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Effort {
    /// The most of one completed step.
    pub most: u32,
    /// Of all completed steps.
    pub total: u64,
    /// Steps completed.
    pub steps: usize,
    /// Time at which a step did not end, s, if any.
    pub stalled_at: Option<f64>,
}

impl Effort {
    fn new(counts: &Counts) -> Self {
        Self {
            most: counts.most(),
            total: counts.iterations.iter().copied().map(u64::from).sum(),
            steps: counts.iterations.len(),
            stalled_at: counts.stalled_at,
        }
    }
}

/// The absolute tolerances, largest first, then the unit-blind rule.
pub fn tolerances(study: &Study) -> Vec<ToleranceRow> {
    let row = |tolerance, dim: &Counts, nondim: &Counts| ToleranceRow {
        tolerance,
        dim: Effort::new(dim),
        nondim: Effort::new(nondim),
    };
    let absolute = study.tolerances.iter().map(|t| row(Some(t.tolerance), &t.dim, &t.nondim));
    let [dim, nondim] =
        [&study.revolute.dim, &study.revolute.nondim].map(|run| Counts::of(&run.series, None));
    absolute.chain([row(None, &dim, &nondim)]).collect()
}
