//! Newton's method: stopping rules, admissible updates, reuse of the tangent.

mod active_set;
mod error;
mod interrupt;
mod iteration_progress;
mod newton_method;
mod rounding_errors;
mod rounding_floor;
mod state_update;
mod stopping;
mod stress_prediction;
mod tangent;
mod tangent_usage;

pub(crate) use active_set::ActiveSet;
pub use error::{EquilibriumError, SolveError, SolveFailure};
pub use interrupt::Interrupt;
pub use newton_method::Newton;
pub(crate) use newton_method::NewtonCheckpoint;
pub(crate) use state_update::{AdmissibleUpdate, FullUpdate, LinearSolution, StateUpdate};
pub use stopping::{NewtonReport, StopRule};
pub(crate) use tangent::NewtonTangent;
