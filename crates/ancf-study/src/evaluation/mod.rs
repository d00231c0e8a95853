//! Evaluation of the table of a study: columns, convergence, sensitivity.

mod convergence;
mod record;
mod sensitivity;

pub use convergence::{Convergence, convergence, observed_orders};
pub use record::{RecordedColumn, StudyRecord};
pub use sensitivity::{LinearFit, ParameterSensitivity, Sensitivity, linear_fit, sensitivity};
