//! Comparison of runs: magnitudes by dimension, tolerances, the part of a motion that neighbouring models share.

mod case;
mod columns;
mod finding;
mod magnitudes;
mod sensitivity;

pub use case::Case;
pub use columns::{identical, last_of, unequal_verdicts};
pub use finding::Finding;
pub use magnitudes::Magnitudes;
pub use sensitivity::{Cause, Comparison, TimeSteps, compare, with_step};
