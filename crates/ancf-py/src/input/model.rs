//! Functions of models.

use std::path::{Path, PathBuf};

use ancf::model::ModelErrors;
use ancf::schema::schema_text;
use ancf::{Model, Scales};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use toml::{Table, Value};

use super::data::{DataReader, read_table, to_python, to_python_with};
use super::errors::{model_error, value_error};
use super::signals::Signals;
use super::threads::detached;

/// Returns the model of data. Raises `ModelError` if it is invalid.
pub(crate) fn valid_model(py: Python<'_>, data: &Value) -> PyResult<Model> {
    detached(py, || Model::from_value(data)).map_err(|errors| model_error(py, &errors, None))
}

/// Reads and checks a model file. Returns its data as dictionaries with the keys of the file.
#[pyfunction]
pub(crate) fn read(py: Python<'_>, path: PathBuf) -> PyResult<Bound<'_, PyAny>> {
    let file = path.display().to_string();
    Model::read(&path).map_err(|errors| model_error(py, &errors, Some(&file)))?;
    let text = Model::read_text(&path).map_err(|errors| model_error(py, &errors, Some(&file)))?;
    let mut data = text.parse().map_err(|error: toml::de::Error| value_error(error))?;
    resolve_files(&mut data, &std::path::absolute(&path)?);
    to_python(py, &Value::Table(data))
}

/// Replaces paths of mesh files and results folders relative to a model file by absolute ones, because the data do not state
/// the file.
pub(super) fn resolve_files(data: &mut Table, path: &Path) {
    let initial =
        data.get_mut("initial").and_then(Value::as_table_mut).and_then(|initial| initial.get_mut("from"));
    if let Some(Value::String(from)) = initial
        && !["undeformed", "equilibrium"].contains(&from.as_str())
    {
        *from = path.with_file_name(&*from).display().to_string();
    }
    let bodies = data.get_mut("bodies").and_then(Value::as_array_mut).into_iter().flatten();
    for body in bodies {
        let shapes = body.get_mut("display").and_then(Value::as_array_mut).into_iter().flatten();
        for file in shapes.filter_map(|shape| shape.get_mut("file")) {
            if let Value::String(name) = file {
                *name = path.with_file_name(&*name).display().to_string();
            }
        }
    }
}

/// Sets the value of a path in the data of a model. Returns the data and the paths that were set.
#[pyfunction]
pub(crate) fn substitute<'py>(
    data: &Bound<'py, PyAny>,
    path: &str,
    value: &Bound<'py, PyAny>,
) -> PyResult<(Bound<'py, PyAny>, Vec<String>)> {
    let (py, mut reader) = (data.py(), DataReader::default());
    let mut model = reader.model(data)?;
    reader.begin_at(path);
    let Some(value) = reader.read(value)? else {
        return Err(PyTypeError::new_err(format!("{path}: found None, expected a value")));
    };
    let set = ancf::reading::substitute(&mut model, path, value);
    let set = set.map_err(|error| model_error(py, &ModelErrors(vec![error]), None))?;
    Ok((to_python_with(py, &model, &reader.callables)?, set))
}

/// Returns the text of a model file.
#[pyfunction]
pub(crate) fn to_toml(data: &Bound<'_, PyAny>) -> PyResult<String> {
    let mut reader = DataReader::default();
    let value = reader.model(data)?;
    if let Some(path) = reader.callables.first() {
        let why = "found a function of Python, expected a value that a file can state";
        return Err(PyTypeError::new_err(format!("{path}: {why}")));
    }
    toml::to_string(&value).map_err(value_error)
}

/// Returns the model in the units of the solver, and these units: length, time, force.
#[pyfunction]
pub(crate) fn scaled<'py>(data: &Bound<'py, PyAny>) -> PyResult<(Bound<'py, PyAny>, [f64; 3])> {
    let py = data.py();
    let model = valid_model(py, &read_table(data)?)?;
    let scales = model.scales().scales;
    let Scales { length, time, force } = scales;
    let scaled = detached(py, || model.scaled(&scales));
    let value = Value::try_from(&scaled).map_err(value_error)?;
    Ok((to_python(py, &value)?, [length, time, force]))
}

/// Returns a description of the parts, constraints and degrees of freedom of a model.
#[pyfunction]
pub(crate) fn diagnose(data: &Bound<'_, PyAny>) -> PyResult<String> {
    let (py, mut reader) = (data.py(), DataReader::default());
    let value = reader.model(data)?;
    let (model, signals) = (valid_model(py, &value)?, Signals::default());
    let (_, diagnosis) = reader.callables.with(py, model, &signals, Model::diagnose)?;
    Ok(diagnosis.to_string())
}

/// Returns the JSON Schema of models.
#[pyfunction]
pub(crate) fn schema() -> String {
    schema_text()
}
