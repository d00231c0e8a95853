//! Where the difference in time between the two forms comes from.

use serde::Serialize;

use crate::paper::study::{Comparison, Run, Study};

/// A problem of the paper by its joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Problem {
    /// Section 3.1.
    Cantilever,
    /// Section 3.2.
    Revolute,
    /// Section 3.3.
    Spherical,
}

impl Problem {
    /// Its name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Cantilever => "cantilever",
            Self::Revolute => "revolute pendulum",
            Self::Spherical => "spherical pendulum",
        }
    }
}

/// The factors of one problem and mesh: `total = longer_step × fewer_iterations × faster_iteration`.
#[derive(Clone, Debug, Serialize)]
pub struct Gain {
    /// The problem.
    pub problem: Problem,
    /// Number of elements.
    pub n: u32,
    /// Time of the dimensional form over that of the non-dimensional one.
    pub total: f64,
    /// Numbers of steps, dimensional over non-dimensional.
    pub longer_step: f64,
    /// Newton iterations per step, dimensional over non-dimensional.
    pub fewer_iterations: f64,
    /// Time per iteration, dimensional over non-dimensional.
    pub faster_iteration: f64,
    /// Time of the dimensional form over that of the non-dimensional one with the same physical step.
    pub same_step_total: f64,
    /// Newton iterations in all, dimensional form.
    pub iterations_dim: u64,
    /// Newton iterations in all, non-dimensional form with the same physical step.
    pub iterations_same_step: u64,
    /// Largest distance between the tips of these two at any instant, m.
    pub tip_difference: f64,
}

/// The factors of all problems and meshes.
pub fn all(study: &Study) -> Vec<Gain> {
    let cantilever = study.cantilever.iter().map(|c| (Problem::Cantilever, c));
    let spherical = study.spherical.iter().map(|c| (Problem::Spherical, c));
    let revolute = [(Problem::Revolute, &study.revolute)];
    cantilever.chain(revolute).chain(spherical).map(|(problem, c)| Gain::new(problem, c)).collect()
}

impl Gain {
    /// Whether both forms did the same number of iterations with the same physical step.
    pub const fn has_equal_iterations(&self) -> bool {
        self.iterations_dim == self.iterations_same_step
    }

    fn new(problem: Problem, comparison: &Comparison) -> Self {
        let Comparison { n, dim, nondim, same_step } = comparison;
        let time_per_iteration = |run: &Run| run.seconds / run.summary.iterations as f64;
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

/// Largest distance between the tips of two runs with the same instants, m.
fn tip_difference(one: &Run, other: &Run) -> f64 {
    let square = |axis: &str| -> Vec<f64> {
        let (a, b) = (one.column(axis), other.column(axis));
        a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).collect()
    };
    let [x, y, z] = ["tip.x", "tip.y", "tip.z"].map(square);
    (0..x.len()).map(|i| (x[i] + y[i] + z[i]).sqrt()).fold(0.0, f64::max)
}
