//! Python exceptions.

use ancf::model::ModelErrors;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// Creates `ancf.ModelError` with all errors of a model and the file from which it was read.
pub(crate) fn model_error(py: Python<'_>, errors: &ModelErrors, file: Option<&str>) -> PyErr {
    let faults: Vec<_> = errors
        .iter()
        .map(|error| {
            let place = error.at.as_ref().map(|at| (at.line, at.column));
            (&error.path, &error.found, &error.wanted, error.hint.as_deref(), place, error.to_string())
        })
        .collect();
    let error = py
        .import("ancf.errors")
        .and_then(|errors| errors.getattr("ModelError"))
        .and_then(|class| class.call_method1("of", (faults, file)));
    error.map_or_else(|why| why, PyErr::from_value)
}

/// Creates a `ValueError` with the text of an error.
pub(crate) fn value_error(error: impl ToString) -> PyErr {
    PyValueError::new_err(error.to_string())
}
