//! Numbers of the report: comparisons with the paper, gain, iterations, gravity.

mod forms;
mod gain;
mod gravity;
mod iterations;
mod paper_results;
mod verdict;

pub use forms::{Agreement, FormValues, Table6, Table7};
pub use gain::Gain;
pub use gravity::GravityCandidate;
pub use iterations::{Figure7, IterationEffort, StepCounts, ToleranceRow, UNIT_BLIND};
pub use paper_results::PaperResults;
pub use verdict::{PaperVerdict, PrintedCheck};
