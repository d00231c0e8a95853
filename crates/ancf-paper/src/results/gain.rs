//! Factors of the difference in time between the two forms.

use serde::Serialize;

use crate::cases::{CaseRuns, PaperCase, PaperRuns, TimedRun};

/// Factors of one problem and mesh: `total = longer_step × fewer_iterations × faster_iteration`.
#[derive(Clone, Debug, Serialize)]
pub struct Gain {
    /// PaperCase.
    pub problem: PaperCase,
    /// Number of elements.
    pub n: u32,
    /// Ratio of times, DIM / Non-DIM.
    pub total: f64,
    /// Ratio of numbers of steps, DIM / Non-DIM.
    pub longer_step: f64,
    /// Ratio of Newton iterations per step, DIM / Non-DIM.
    pub fewer_iterations: f64,
    /// Ratio of times per iteration, DIM / Non-DIM.
    pub faster_iteration: f64,
    /// Ratio of times with the same physical step, DIM / Non-DIM.
    pub same_step_total: f64,
    /// Total Newton iterations, dimensional form.
    pub iterations_dim: u64,
    /// Total Newton iterations, non-dimensional form with the same physical step.
    pub iterations_same_step: u64,
    /// Largest distance between the tips of these two runs, m.
    pub tip_difference: f64,
}

/// Returns the factors of all problems and meshes.
pub fn all(runs: &PaperRuns) -> Vec<Gain> {
    let cantilever = runs.cantilever.iter().map(|c| (PaperCase::Cantilever, c));
    let spherical = runs.spherical.iter().map(|c| (PaperCase::Spherical, c));
    let revolute = [(PaperCase::Revolute, &runs.revolute)];
    cantilever.chain(revolute).chain(spherical).map(|(problem, c)| Gain::new(problem, c)).collect()
}

impl Gain {
    /// True if both forms need the same number of iterations with the same physical step.
    pub const fn has_equal_iterations(&self) -> bool {
        self.iterations_dim == self.iterations_same_step
    }

    fn new(problem: PaperCase, comparison: &CaseRuns) -> Self {
        let CaseRuns { n, dim, nondim, same_step } = comparison;
        let time_per_iteration = |run: &TimedRun| run.seconds / run.summary.iterations as f64;
        Self {
            problem,
            n: *n,
            total: dim.seconds / nondim.seconds,
            longer_step: dim.summary.steps as f64 / nondim.summary.steps as f64,
            fewer_iterations: dim.iterations_per_step() / nondim.iterations_per_step(),
            faster_iteration: time_per_iteration(dim) / time_per_iteration(nondim),
            same_step_total: dim.seconds / same_step.seconds,
            iterations_dim: dim.summary.iterations,
            iterations_same_step: same_step.summary.iterations,
            tip_difference: tip_difference(dim, same_step),
        }
    }
}

/// Returns the largest distance between the tips of two runs with the same instants, m.
fn tip_difference(one: &TimedRun, other: &TimedRun) -> f64 {
    let square = |axis: &str| -> Vec<f64> {
        let (a, b) = (one.column(axis), other.column(axis));
        a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).collect()
    };
    let [x, y, z] = ["tip.x", "tip.y", "tip.z"].map(square);
    (0..x.len()).map(|i| (x[i] + y[i] + z[i]).sqrt()).fold(0.0, f64::max)
}
