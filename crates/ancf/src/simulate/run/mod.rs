//! One analysis in progress: data, observers, checkpoints and summary.

mod analysis_run;
mod checkpoint;
mod end_conditions;
mod error_estimate;
mod finer_motion;
mod observer;
mod outcome;
mod simulation;
mod step_control;
mod summary;

pub(crate) use analysis_run::{AnalysisRun, RunResult, turn_warning};
pub use checkpoint::{Checkpoint, ResumeError};
pub(crate) use checkpoint::{StepCounts, fingerprint, hash_of};
pub(crate) use end_conditions::EndConditions;
pub(crate) use error_estimate::ErrorEstimate;
pub use observer::Observer;
pub(crate) use outcome::{finer_failure, outcome};
pub use simulation::{Extension, Simulation, SimulationBuilder};
pub(crate) use step_control::{
    SMALL_REMAINDER, StepControl, TIME_TOLERANCE, error_control, newton_method, started,
};
pub use summary::{EigenvalueCount, Outcome, Summary};
