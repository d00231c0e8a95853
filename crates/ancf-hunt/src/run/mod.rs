//! Runs of models, recorded in memory.

mod record;
mod resume;
mod runner;

pub use record::{Record, Run, Verdict};
pub use resume::resumed;
pub use runner::{run, run_in};
