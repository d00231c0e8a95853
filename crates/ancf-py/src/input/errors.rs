//! Python exceptions.

use ancf::ModelError;
use ancf::model::ModelErrors;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// Arguments of `ancf.Fault`: path, found, expected, hint, line and column, text.
pub(crate) type FaultArguments = (String, String, String, Option<String>, Option<(usize, usize)>, String);

/// Returns the arguments of `ancf.Fault` for each error.
pub(crate) fn faults(errors: &[ModelError]) -> Vec<FaultArguments> {
    let arguments = |error: &ModelError| {
        let place = error.at.as_ref().map(|at| (at.line, at.column));
        let (path, found, expected) = (error.path.clone(), error.found.clone(), error.expected.clone());
        (path, found, expected, error.hint.clone(), place, error.to_string())
    };
    errors.iter().map(arguments).collect()
}

/// Creates `ancf.ModelError` with all errors of a model and the file from which it was read.
pub(crate) fn model_error(py: Python<'_>, errors: &ModelErrors, file: Option<&str>) -> PyErr {
    error_of_faults(py, faults(errors), file)
}

/// Creates `ancf.ModelError` with the errors of a part of a model. The label of the part is before each message.
pub(crate) fn part_error(py: Python<'_>, errors: &ModelErrors, part: Option<&str>) -> PyErr {
    let mut faults = faults(errors);
    for (.., text) in &mut faults {
        *text = part.map_or_else(|| text.clone(), |part| format!("{part}: {text}"));
    }
    error_of_faults(py, faults, None)
}

fn error_of_faults(py: Python<'_>, faults: Vec<FaultArguments>, file: Option<&str>) -> PyErr {
    let error = py
        .import("ancf.errors")
        .and_then(|module| module.getattr("ModelError"))
        .and_then(|class| class.call_method1("of", (faults, file)));
    error.map_or_else(|why| why, PyErr::from_value)
}

/// Creates a `ValueError` with the text of an error.
pub(crate) fn value_error(error: impl ToString) -> PyErr {
    PyValueError::new_err(error.to_string())
}
