//! Problems of the paper: models, runs, printed numbers, references.

mod compound_pendulum;
mod conditioning;
mod measurement;
pub mod models;
pub mod peers;
pub mod published;

pub use compound_pendulum::{CompoundPendulum, TipState};
pub use conditioning::{ConditionRow, MatrixForm};
pub use measurement::{
    CaseRuns, IterationCounts, MAX_ITERATIONS, PaperRuns, STANDARD_GRAVITY, TimedRun, ToleranceRuns,
};
pub use models::PaperCase;
