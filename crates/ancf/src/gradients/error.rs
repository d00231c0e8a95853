use thiserror::Error;

use crate::errors::ModelErrors;

/// Cause for which there are no gradients.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum GradientError {
    /// The model or a parameter is not valid.
    #[error("{0}")]
    Model(#[from] ModelErrors),
    /// The analysis failed, or a result has no derivative.
    #[error("{reason}{}", place(.at))]
    Failed {
        /// Reason.
        reason: String,
        /// Place in the model; empty without one.
        at: String,
    },
    /// The interrupt flag was set.
    #[error("the computation of gradients was interrupted")]
    Interrupted,
}

impl GradientError {
    pub(super) fn failed(reason: impl Into<String>) -> Self {
        Self::Failed { reason: reason.into(), at: String::new() }
    }
}

/// Place of a failure, as the end of a message.
fn place(at: &str) -> String {
    if at.is_empty() { String::new() } else { format!(" ({at})") }
}
