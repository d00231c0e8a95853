//! Errors as JSON.

use ancf::ModelError;
use serde::Serialize;

/// JSON output of a command that was rejected.
#[derive(Debug, Serialize)]
pub struct JsonErrors {
    errors: Vec<JsonError>,
}

/// Error. Unknown properties are null.
#[derive(Debug, Default, Serialize)]
struct JsonError {
    /// File with the error.
    file: Option<String>,
    /// Line, from 1.
    line: Option<usize>,
    /// Column in characters, from 1.
    column: Option<usize>,
    /// Path of the key.
    path: Option<String>,
    /// Value found.
    found: Option<String>,
    /// Value required.
    expected: Option<String>,
    /// Suggestion.
    hint: Option<String>,
    /// Complete message in one line.
    message: String,
}

impl JsonErrors {
    /// Converts the errors of a file.
    pub fn from_errors(errors: &[ModelError], file: &str) -> Self {
        let convert = |error: &ModelError| JsonError {
            file: Some(file.to_owned()),
            line: error.at.as_ref().map(|at| at.line),
            column: error.at.as_ref().map(|at| at.column),
            path: Some(error.path.clone()).filter(|path| !path.is_empty()),
            found: Some(error.found.clone()),
            expected: Some(error.expected.clone()).filter(|expected| !expected.is_empty()),
            hint: error.hint.clone(),
            message: error.to_string(),
        };
        Self { errors: errors.iter().map(convert).collect() }
    }

    /// Converts any other error.
    pub fn from_message(message: impl Into<String>) -> Self {
        Self { errors: vec![JsonError { message: message.into(), ..JsonError::default() }] }
    }
}
