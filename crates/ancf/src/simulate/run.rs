use std::io;
use std::ops::ControlFlow;

use ancf_solver::eigen::EigenError;
use ancf_solver::newton::{EquilibriumError, Interrupt, SolveError, SolveFailure};

use super::observer::Observer;
use super::summary::Summary;
use crate::assembly::Assembly;
use crate::failure::{Blame, Watch};

/// An analysis under way.
pub(crate) struct Run<'a> {
    pub(crate) assembly: &'a Assembly,
    pub(crate) interrupt: &'a Interrupt,
    pub(crate) observer: &'a mut dyn Observer,
    pub(crate) summary: Summary,
    pub(crate) watch: Watch,
}

/// How an analysis ended, in the units of the solver: finished or stopped by a sink, or why not.
pub(crate) type Ended = io::Result<Result<ControlFlow<()>, Reason>>;

/// Why an analysis could not go on.
pub(crate) enum Reason {
    Motion(SolveError, Option<Blame>),
    Equilibrium(EquilibriumError, Option<Blame>),
    Eigen(EigenError),
    /// Motions that nothing holds, in words.
    Mechanism(String),
}

impl Reason {
    pub(crate) fn is_interruption(&self) -> bool {
        match self {
            Self::Motion(error, _) => error.failure == SolveFailure::Interrupted,
            Self::Equilibrium(error, _) => error.cause.failure == SolveFailure::Interrupted,
            Self::Eigen(error) => *error == EigenError::Interrupted,
            Self::Mechanism(_) => false,
        }
    }
}

impl From<SolveError> for Reason {
    fn from(error: SolveError) -> Self {
        Self::Motion(error, None)
    }
}

impl From<EquilibriumError> for Reason {
    fn from(error: EquilibriumError) -> Self {
        Self::Equilibrium(error, None)
    }
}

impl From<EigenError> for Reason {
    fn from(error: EigenError) -> Self {
        Self::Eigen(error)
    }
}
