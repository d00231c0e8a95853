//! Newton's method: stopping rules, line search, reuse of the tangent.

mod active_set;
mod error;
mod interrupt;
mod iteration;
mod line_search;
mod report;
mod rounding_floor;
mod tangent;

pub(crate) use active_set::ActiveSet;
pub use error::{EquilibriumError, Failure, SolveError};
pub use interrupt::Interrupt;
pub(crate) use iteration::NewtonMemory;
pub use iteration::{Newton, Stop};
pub(crate) use line_search::{FullUpdate, LineSearch, LinearSolution, StateUpdate, dot};
pub use report::Report;
