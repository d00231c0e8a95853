//! Failures that end an analysis.

use ancf_solver::eigen::EigenError;
use ancf_solver::newton::{EquilibriumError, SolveError, SolveFailure};

use super::cause::FailureCause;

/// Failure that ends an analysis.
pub(crate) enum RunFailure {
    /// Failed iteration.
    Solve(SolveError, Option<FailureCause>),
    /// Failed search for an equilibrium.
    Equilibrium(EquilibriumError, Option<FailureCause>),
    /// Failed eigenvalue search.
    Eigen(EigenError),
    /// Description of unsupported motions.
    Mechanism(String),
    /// Failed search for the equilibrium from which a motion starts.
    Start(Box<Self>),
    /// Results folder whose state the program did not supply.
    NoState(String),
}

impl RunFailure {
    /// True if the interrupt flag ended the analysis.
    pub(crate) fn is_interruption(&self) -> bool {
        match self {
            Self::Solve(error, _) => error.failure == SolveFailure::Interrupted,
            Self::Equilibrium(error, _) => error.cause.failure == SolveFailure::Interrupted,
            Self::Eigen(error) => *error == EigenError::Interrupted,
            Self::Mechanism(_) | Self::NoState(_) => false,
            Self::Start(failure) => failure.is_interruption(),
        }
    }
}

impl From<SolveError> for RunFailure {
    fn from(error: SolveError) -> Self {
        Self::Solve(error, None)
    }
}

impl From<EquilibriumError> for RunFailure {
    fn from(error: EquilibriumError) -> Self {
        Self::Equilibrium(error, None)
    }
}

impl From<EigenError> for RunFailure {
    fn from(error: EigenError) -> Self {
        Self::Eigen(error)
    }
}
