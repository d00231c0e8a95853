//! Parts of a model, checked as they are built.

use ancf::model::{ModelErrors, check_part as check};
use pyo3::create_exception;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyList, PyString, PyTuple};
use toml::{Table, Value};

create_exception!(ancf, ModelError, PyValueError, "All that is wrong with a model, one line for each.");

/// Checks a part of a model by its definition in the schema; raises `ModelError` with all that is wrong.
#[pyfunction]
pub fn check_part(definition: &str, data: &Bound<'_, PyAny>) -> PyResult<()> {
    check(definition, &value(data)?).map_err(refused)
}

/// The errors of a model as the exception of Python.
fn refused(errors: ModelErrors) -> PyErr {
    ModelError::new_err(errors.to_string())
}

/// Plain data of Python; a callable stands for a number, as where functions of time are wanted.
fn value(any: &Bound<'_, PyAny>) -> PyResult<Value> {
    if any.is_instance_of::<PyBool>() {
        return Ok(Value::Boolean(any.extract()?));
    }
    if any.is_instance_of::<PyInt>() {
        return Ok(Value::Integer(any.extract()?));
    }
    if any.is_instance_of::<PyFloat>() {
        return Ok(Value::Float(any.extract()?));
    }
    if any.is_instance_of::<PyString>() {
        return Ok(Value::String(any.extract()?));
    }
    if let Ok(dict) = any.cast::<PyDict>() {
        return Ok(Value::Table(table(dict)?));
    }
    if any.is_instance_of::<PyList>() || any.is_instance_of::<PyTuple>() {
        return Ok(Value::Array(any.try_iter()?.map(|item| value(&item?)).collect::<PyResult<_>>()?));
    }
    if any.is_callable() {
        return Ok(Value::Float(1.0));
    }
    Err(PyTypeError::new_err(format!("a model holds no {}", any.get_type().name()?)))
}

/// A table; what is `None` is left out.
fn table(dict: &Bound<'_, PyDict>) -> PyResult<Table> {
    let given = dict.iter().filter(|(_, item)| !item.is_none());
    given.map(|(key, item)| Ok((key.extract()?, value(&item)?))).collect()
}
