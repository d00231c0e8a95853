//! Reading of the results of a run.

mod open_error;
mod results;
mod run_status;

pub use open_error::OpenError;
pub use results::{Results, StoredState};
pub use run_status::{KILLED, RunStatus};
