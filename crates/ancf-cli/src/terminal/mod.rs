//! Output of the program: colours, messages, errors, progress, signals, outcomes.

mod colour;
mod json_errors;
mod locale;
mod model_errors;
mod numbers;
mod outcome;
mod output_mode;
mod progress;
mod signal;
mod standard_output;

pub use colour::{Colour, is_stdout_coloured};
pub use json_errors::JsonErrors;
pub use locale::is_unicode;
pub use numbers::count;
#[cfg(not(feature = "figures"))]
pub use outcome::reject_figures;
pub use outcome::{Ended, print_model_errors, report_argument_error, report_model_errors};
pub use output_mode::{
    OutputMode, print, print_error, print_json, print_output, print_status, set_output_mode,
};
#[cfg(feature = "figures")]
pub use progress::spinner;
pub use progress::{RunProgress, case_bar};
pub use signal::{interrupt, is_terminated};
pub use standard_output::check_output;
