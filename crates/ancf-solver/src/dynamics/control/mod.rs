//! Step size control by estimates of the error.

mod adaptive;
mod contact_changes;
mod error_estimate;
mod law_changes;
mod unseen_variation;

pub use adaptive::{AdaptiveCheckpoint, AdaptiveStepper, ErrorControl};
pub use unseen_variation::{TimeFunctions, UnseenVariation};
