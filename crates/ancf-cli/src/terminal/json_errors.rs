//! Errors as JSON.

use std::path::Path;

use ancf::ModelError;
use serde::Serialize;

/// The answer to what cannot be done.
#[derive(Debug, Serialize)]
pub struct Faults {
    errors: Vec<Fault>,
}

/// What is wrong; what is not known is null.
#[derive(Debug, Default, Serialize)]
struct Fault {
    /// The file that it is about.
    file: Option<String>,
    /// From 1.
    line: Option<usize>,
    /// In characters, from 1.
    column: Option<usize>,
    /// The key.
    path: Option<String>,
    found: Option<String>,
    wanted: Option<String>,
    hint: Option<String>,
    /// All of it in one line.
    message: String,
}

impl Faults {
    /// Errors in a file of the user.
    pub fn of(errors: &[ModelError], file: &Path) -> Self {
        let fault = |error: &ModelError| Fault {
            file: Some(file.display().to_string()),
            line: error.at.as_ref().map(|at| at.line),
            column: error.at.as_ref().map(|at| at.column),
            path: Some(error.path.clone()).filter(|path| !path.is_empty()),
            found: Some(error.found.clone()),
            wanted: Some(error.wanted.clone()),
            hint: error.hint.clone(),
            message: error.to_string(),
        };
        Self { errors: errors.iter().map(fault).collect() }
    }

    /// Any other error.
    pub fn other(message: impl Into<String>) -> Self {
        Self { errors: vec![Fault { message: message.into(), ..Fault::default() }] }
    }
}
