use thiserror::Error;

use crate::errors::ModelErrors;
use crate::failure::RunFailure;
use crate::simulate::{Outcome, Simulation, outcome};

/// Error of a [`Stepper`](super::Stepper).
#[derive(Clone, Debug, Error)]
pub enum StepError {
    /// The model is not valid, or is not a motion that can be advanced step by step.
    #[error(transparent)]
    Model(#[from] ModelErrors),
    /// An argument is not valid. Nothing has changed.
    #[error("{0}")]
    Argument(String),
    /// The computation failed: time, cause, place and remedy. The state is that of the last accepted substep.
    #[error("{0}")]
    Failed(String),
    /// The interrupt flag stopped the step. The state is that of the last accepted substep.
    #[error("the step was interrupted")]
    Interrupted,
    /// The snapshot does not belong to the model, or is damaged. Nothing has changed.
    #[error("{0}")]
    Snapshot(String),
}

/// Error of an argument.
pub(super) fn argument(what: &str, found: impl std::fmt::Display, expected: &str) -> StepError {
    StepError::Argument(format!("{what}: found {found}, expected {expected}"))
}

/// Error of a failed computation with time, cause, place and remedy.
pub(super) fn failure_message(simulation: &Simulation, failure: RunFailure) -> StepError {
    let Simulation { scaled, assembly, .. } = simulation;
    let outcome = outcome(Err(failure), scaled, assembly, simulation.scales());
    match outcome {
        Outcome::Failed { .. } => StepError::Failed(outcome.failure(&scaled.analysis).unwrap_or_default()),
        _ => StepError::Interrupted,
    }
}
