//! Comparison of runs: magnitudes by dimension, tolerances, the part of a motion that neighbouring models share.

mod case;
mod columns;
mod finding;
mod magnitudes;

pub use case::Case;
pub use columns::{compare, identical, last_of, unequal_verdicts};
pub use finding::Finding;
pub use magnitudes::Magnitudes;
