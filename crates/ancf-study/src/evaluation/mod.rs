//! Evaluation of the table of a study: columns, convergence, sensitivity.

mod convergence;
mod record;
mod sensitivity;

pub use convergence::{Convergence, convergence};
pub use record::{RecordedColumn, StudyRecord};
pub use sensitivity::{ParameterSensitivity, Sensitivity, sensitivity};
