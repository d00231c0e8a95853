use thiserror::Error;

use super::report::Report;

/// Why a Newton iteration failed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum Failure {
    /// The iteration matrix has no usable factorisation.
    #[error("the iteration matrix is singular: a joint repeats another, or a motion is held by nothing")]
    Singular,
    /// The factors of the iteration matrix do not fit into memory.
    #[error("the factors of the iteration matrix do not fit into memory")]
    Memory,
    /// Numbers became infinite or not a number.
    #[error("the iteration diverged: numbers became infinite or not a number")]
    Diverged,
    /// Increments stopped to decrease above the rounding error.
    #[error("the iteration stagnated above the rounding error")]
    Stagnated,
    /// The solution that was found is one that a term does not admit.
    #[error(
        "the solution turns an element inside out, or a slider leaves its beam, or ends of a spring meet"
    )]
    Inverted,
    /// The equilibrium that was found is not as stable as the one before it, and nothing between them tells why.
    #[error("the stability changed within the step")]
    Unstable,
    /// The path of equilibria turned too far within a step.
    #[error("the path of equilibria turns too far within the step")]
    Turned,
    /// The permitted number of iterations was not enough.
    #[error("the iteration did not converge in the iterations permitted")]
    NotConverged,
    /// The error of a step exceeds its share of the tolerance even in the smallest permitted step.
    #[error("the step fell below the smallest permitted: the motion jumps, or the tolerance is too tight")]
    StepTooSmall,
    /// It was ended from outside.
    #[error("the iteration was interrupted")]
    Interrupted,
}

/// A failed solution of the equations of motion, in the units of the solver.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("{failure}{}", told(*iterations, *residual, *increment))]
pub struct SolveError {
    /// Why.
    pub failure: Failure,
    /// Time that was to be reached.
    pub t: f64,
    /// Iterations done.
    pub iterations: u32,
    /// Euclidean norm of the last residual.
    pub residual: f64,
    /// Euclidean norm of the last increment of the coordinates.
    pub increment: f64,
    /// The equation whose residual exceeds its rounding error most: a coordinate, or a multiplier after all coordinates; none
    /// if no iteration tells.
    pub worst: Option<usize>,
}

/// How an iteration went, if there was one.
fn told(iterations: u32, residual: f64, increment: f64) -> String {
    if iterations == 0 && residual == 0.0 {
        return String::new();
    }
    format!(" (after {iterations} iterations, |r| = {residual:.3e}, |dq| = {increment:.3e})")
}

impl SolveError {
    /// Whether a smaller step is no help: somebody wants an end.
    pub(crate) fn is_final(&self) -> bool {
        self.failure == Failure::Interrupted
    }

    /// A failure before any iteration.
    pub(crate) const fn at_start(failure: Failure) -> Self {
        Self::at(0.0, failure)
    }

    /// The failure of an iteration that went as reported, whose worst equation is `worst`.
    pub(crate) const fn after(report: Report, t: f64, failure: Failure, worst: usize) -> Self {
        let Report { iterations, residual, increment, .. } = report;
        Self { failure, t, iterations, residual, increment, worst: Some(worst) }
    }

    /// A failure at a time, outside any iteration.
    pub(crate) const fn at(t: f64, failure: Failure) -> Self {
        Self { failure, t, iterations: 0, residual: 0.0, increment: 0.0, worst: None }
    }
}

/// There is no equilibrium, or none that was found, beyond a load factor.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("no equilibrium found beyond load factor {reached}; at {load}: {cause}")]
pub struct EquilibriumError {
    /// Load factor of the last equilibrium.
    pub reached: f64,
    /// Load factor of the last attempt.
    pub load: f64,
    /// How the last attempt failed.
    #[source]
    pub cause: SolveError,
}
