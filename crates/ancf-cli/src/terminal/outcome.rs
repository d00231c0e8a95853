//! Outcome of a command, and the rejection of bad input.

use std::fs;
use std::path::Path;

use ancf::ModelError;

use super::json_errors::JsonErrors;
use super::model_errors;
use super::output_mode::{print_error, print_json};

/// Outcome of a command, for the exit code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// Done.
    Done,
    /// The analysis failed. The results so far are written.
    Failed,
    /// The input is invalid. Nothing is written.
    BadInput,
    /// Stopped by a signal. The results so far are written.
    Stopped,
}

/// Reports the errors of a file.
pub fn report_model_errors(errors: &[ModelError], file: &Path) -> Ended {
    let (name, text) = (file.display().to_string(), fs::read(file).unwrap_or_default());
    print_model_errors(errors, &name, &String::from_utf8_lossy(&text));
    print_json(&JsonErrors::from_errors(errors, &name));
    Ended::BadInput
}

/// Prints the errors of a text, with the name of its file, on standard error.
pub fn print_model_errors(errors: &[ModelError], name: &str, text: &str) {
    print_error(model_errors::render(errors, name, text).trim_end());
}

/// Reports an error of the arguments.
pub fn report_argument_error(message: &str) -> Ended {
    print_error(&format!("error: {message}"));
    print_json(&JsonErrors::from_message(message));
    Ended::BadInput
}

/// Rejects a command that needs figures.
#[cfg(not(feature = "figures"))]
pub fn reject_figures() -> Ended {
    report_argument_error("this program was built without figures; build it with the cargo feature `figures`")
}
