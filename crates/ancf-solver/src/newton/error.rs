use thiserror::Error;

use super::stopping::NewtonReport;
use crate::equations::Inadmissibility;

/// Cause of failure of a Newton iteration.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum SolveFailure {
    /// The iteration matrix has no usable factorisation.
    #[error("the iteration matrix is singular: a joint is redundant, or a motion is unconstrained")]
    Singular,
    /// The factors of the iteration matrix do not fit into memory.
    #[error("the memory does not suffice for the factors of the iteration matrix")]
    Memory,
    /// A residual is infinite or not a number.
    #[error("the iteration diverged: a residual is infinite or not a number")]
    Diverged,
    /// The increments stopped decreasing above the rounding error.
    #[error("the iteration stagnated above the rounding error")]
    Stagnated,
    /// A term does not admit the solution.
    #[error("the solution is inadmissible: {0}")]
    Inadmissible(Inadmissibility),
    /// The number of turns of a joint angle is ambiguous.
    #[error("the number of turns of a joint angle is ambiguous: its rate changes too much in the step")]
    AmbiguousTurns,
    /// The step made energy.
    #[error(
        "the integration makes energy: energies less work plus dissipation rise above the permitted share"
    )]
    EnergyMade,
    /// The equilibrium is less stable than the previous one, and no limit point was found between them.
    #[error("the stability changed within the step")]
    Unstable,
    /// The equilibrium path turns too far within a step.
    #[error("the equilibrium path turns too far within the step")]
    Turned,
    /// A drive, a body or a section turns too far within a load increment.
    #[error("a drive, a body or a section turns too far within the increment")]
    Rotated,
    /// A body passes through its contact partner within a step.
    #[error("a body passes through its contact partner within the step")]
    Crossed,
    /// The iteration limit was reached.
    #[error("the iteration did not converge within the iteration limit")]
    NotConverged,
    /// The error of a step exceeds the tolerance even at the smallest permitted step size.
    #[error("the step is below the smallest permitted step: the motion jumps, or the tolerance is too small")]
    StepTooSmall,
    /// The interrupt flag was set.
    #[error("the iteration was interrupted")]
    Interrupted,
}

/// Failed solution of the equations of motion, in solver units.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("{failure}{}", format_norms(*iterations, *residual, *increment))]
pub struct SolveError {
    /// Cause of failure.
    pub failure: SolveFailure,
    /// Time at the end of the step.
    pub t: f64,
    /// Number of iterations.
    pub iterations: u32,
    /// Euclidean norm of the last residual.
    pub residual: f64,
    /// Euclidean norm of the last increment of the coordinates.
    pub increment: f64,
    /// Equation with the largest ratio of residual to rounding error: a coordinate, or a multiplier numbered after all
    /// coordinates. `None` if there was no iteration.
    pub worst: Option<usize>,
}

/// Formats the iteration count and the norms, if there was an iteration.
fn format_norms(iterations: u32, residual: f64, increment: f64) -> String {
    if iterations == 0 && residual == 0.0 {
        return String::new();
    }
    format!(" (after {iterations} iterations, |r| = {residual:.3e}, |dq| = {increment:.3e})")
}

impl SolveError {
    /// Returns true if a smaller step cannot help because the analysis was interrupted.
    pub(crate) fn is_final(&self) -> bool {
        self.failure == SolveFailure::Interrupted
    }

    /// Creates a failure before the first iteration.
    pub(crate) const fn at_start(failure: SolveFailure) -> Self {
        Self::at(0.0, failure)
    }

    /// Creates a failure after an iteration with the given report and worst equation.
    pub(crate) const fn after(report: NewtonReport, t: f64, failure: SolveFailure, worst: usize) -> Self {
        let NewtonReport { iterations, residual, increment, .. } = report;
        Self { failure, t, iterations, residual, increment, worst: Some(worst) }
    }

    /// Creates a failure at a time outside an iteration.
    pub const fn at(t: f64, failure: SolveFailure) -> Self {
        Self { failure, t, iterations: 0, residual: 0.0, increment: 0.0, worst: None }
    }
}

/// No equilibrium was found beyond a load factor.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("no equilibrium found beyond load factor {reached}; at {load}: {cause}")]
pub struct EquilibriumError {
    /// Load factor of the last equilibrium.
    pub reached: f64,
    /// Load factor of the last attempt.
    pub load: f64,
    /// Failure of the last attempt.
    #[source]
    pub cause: SolveError,
}
