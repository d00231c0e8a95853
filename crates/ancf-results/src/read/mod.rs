//! Reading of the results of a run.

mod given_state;
mod open_error;
mod results;
mod run_status;

pub use given_state::given_state;
pub use open_error::OpenError;
pub use results::{Results, StoredState};
pub use run_status::{KILLED, RunStatus};
