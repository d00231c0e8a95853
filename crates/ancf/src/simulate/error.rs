use std::io;

use thiserror::Error;

use super::run::ResumeError;
use crate::errors::ModelErrors;

/// Error of a run: invalid model or checkpoint, or failed recording. A failed computation is an [`Outcome`](crate::Outcome).
#[derive(Debug, Error)]
pub enum Error {
    /// The model is not valid.
    #[error(transparent)]
    Model(#[from] ModelErrors),
    /// The checkpoint does not belong to the simulation.
    #[error(transparent)]
    Checkpoint(#[from] ResumeError),
    /// The sink or observer could not record.
    #[error("results could not be written")]
    Sink(#[from] io::Error),
}
