use std::path::PathBuf;

use ancf::model::{ModelErrors, schema_text};
use ancf::{Model, Scales};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use toml::Value;

use crate::data::{Data, object, restored, table};
use crate::signals::Signals;

/// `ancf.ModelError` with all errors of a model, and the file that it is from.
pub(crate) fn refused(py: Python<'_>, errors: &ModelErrors, file: Option<&str>) -> PyErr {
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

/// The model that data state, if it is valid.
pub(crate) fn valid(py: Python<'_>, data: &Value) -> PyResult<Model> {
    py.detach(|| Model::from_value(data)).map_err(|errors| refused(py, &errors, None))
}

fn unprintable(error: impl ToString) -> PyErr {
    PyValueError::new_err(error.to_string())
}

fn plain_data<'py>(py: Python<'py>, model: &Model) -> PyResult<Bound<'py, PyAny>> {
    object(py, &Value::try_from(model).map_err(unprintable)?)
}

/// Reads and checks a model file; its data as dictionaries, with the keys that the file has.
#[pyfunction]
pub(crate) fn read(py: Python<'_>, path: PathBuf) -> PyResult<Bound<'_, PyAny>> {
    let file = path.display().to_string();
    Model::read(&path).map_err(|errors| refused(py, &errors, Some(&file)))?;
    let text = std::fs::read_to_string(&path)?;
    object(py, &Value::Table(text.parse().map_err(unprintable)?))
}

/// Data of a model in which a path has another value, and the paths that were set.
#[pyfunction]
pub(crate) fn substitute<'py>(
    data: &Bound<'py, PyAny>,
    path: &str,
    value: &Bound<'py, PyAny>,
) -> PyResult<(Bound<'py, PyAny>, Vec<String>)> {
    let (py, mut reader) = (data.py(), Data::default());
    let mut model = reader.model(data)?;
    reader.begin_at(path);
    let Some(value) = reader.read(value)? else {
        return Err(PyTypeError::new_err(format!("{path}: found None, wanted a value")));
    };
    let set = ancf::model::substitute(&mut model, path, value);
    let set = set.map_err(|error| refused(py, &ModelErrors(vec![error]), None))?;
    Ok((restored(py, &model, &reader.callables)?, set))
}

/// The text of a model file.
#[pyfunction]
pub(crate) fn to_toml(data: &Bound<'_, PyAny>) -> PyResult<String> {
    let mut reader = Data::default();
    let value = reader.model(data)?;
    if let Some(path) = reader.callables.first() {
        let why = "found a function of Python, wanted what a file can say";
        return Err(PyTypeError::new_err(format!("{path}: {why}")));
    }
    toml::to_string(&value).map_err(unprintable)
}

/// The model in the units in which its equations are solved, and these: length, time, force.
#[pyfunction]
pub(crate) fn scaled<'py>(data: &Bound<'py, PyAny>) -> PyResult<(Bound<'py, PyAny>, [f64; 3])> {
    let py = data.py();
    let model = valid(py, &table(data)?)?;
    let scales = model.scales().scales;
    let Scales { length, time, force } = scales;
    let scaled = py.detach(|| model.scaled(&scales));
    Ok((plain_data(py, &scaled)?, [length, time, force]))
}

/// What the model consists of, what joints tie and what is free to move, in words.
#[pyfunction]
pub(crate) fn diagnose(data: &Bound<'_, PyAny>) -> PyResult<String> {
    let (py, mut reader) = (data.py(), Data::default());
    let value = reader.model(data)?;
    let (model, signals) = (valid(py, &value)?, Signals::default());
    let (_, diagnosis) = reader.callables.with(py, model, &signals, Model::diagnose)?;
    Ok(diagnosis.to_string())
}

/// The JSON Schema of models.
#[pyfunction]
pub(crate) fn schema() -> String {
    schema_text()
}
