use std::io;

use thiserror::Error;

use super::checkpoint::Mismatch;
use crate::errors::ModelErrors;

/// Why a run could not be done or recorded. That the numerics gave up is not an error but an [`Outcome`](crate::Outcome).
#[derive(Debug, Error)]
pub enum Error {
    /// The model is not valid.
    #[error(transparent)]
    Model(#[from] ModelErrors),
    /// A checkpoint is not one of the simulation.
    #[error(transparent)]
    Checkpoint(#[from] Mismatch),
    /// A sink could not record.
    #[error("results could not be written")]
    Sink(#[from] io::Error),
}
