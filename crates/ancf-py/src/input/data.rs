//! Conversion of data between Python and TOML.

use pyo3::IntoPyObjectExt;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyList, PyMapping, PySequence, PyString};
use toml::{Table, Value};

use super::callables::{CallableRole, Callables};

/// Reader of model data from Python: dictionaries, sequences, numbers of Python and NumPy, text, and objects with `to_dict`.
///
/// Values `None` are omitted. A function becomes an external function of the model.
#[derive(Debug, Default)]
pub(crate) struct DataReader {
    path: String,
    depth: usize,
    pub(crate) callables: Callables,
}

/// Maximum nesting depth of a model.
const MAX_DEPTH: usize = 64;

impl DataReader {
    /// Returns the data of an object, or nothing if it is `None`.
    pub(crate) fn read(&mut self, any: &Bound<'_, PyAny>) -> PyResult<Option<Value>> {
        if any.is_none() {
            return Ok(None);
        }
        self.value(any).map(Some)
    }

    /// Returns the data of a model, empty if it is `None`.
    pub(crate) fn model(&mut self, any: &Bound<'_, PyAny>) -> PyResult<Value> {
        Ok(self.read(any)?.unwrap_or_else(|| Value::Table(Table::new())))
    }

    /// Sets the path of the next object.
    pub(crate) fn begin_at(&mut self, path: &str) {
        self.path = path.to_owned();
    }

    fn value(&mut self, any: &Bound<'_, PyAny>) -> PyResult<Value> {
        if self.depth == MAX_DEPTH {
            return Err(PyValueError::new_err("a model that holds itself, or is nested too deeply"));
        }
        self.depth += 1;
        let value = self.shallow(any);
        self.depth -= 1;
        value
    }

    fn shallow(&mut self, any: &Bound<'_, PyAny>) -> PyResult<Value> {
        if let Ok(yes) = any.cast::<PyBool>() {
            return Ok(Value::Boolean(yes.is_true()));
        }
        if let Ok(x) = any.cast::<PyFloat>() {
            return Ok(Value::Float(x.extract()?));
        }
        if let Ok(text) = any.cast::<PyString>() {
            return Ok(Value::String(text.to_str()?.to_owned()));
        }
        if let Ok(table) = any.cast::<PyMapping>() {
            return self.table(table);
        }
        if any.hasattr("to_dict")? {
            return self.value(&any.call_method0("to_dict")?);
        }
        if any.is_callable() {
            return Ok(external(self.callables.name(any, &self.path, CallableRole::Time)));
        }
        if any.is_instance_of::<PyInt>() {
            return integer(any).map_err(|_| self.unknown(any, "a number within the range of doubles"));
        }
        // Arrays and scalars of NumPy and similar packages.
        if any.hasattr("tolist")? {
            return self.value(&any.call_method0("tolist")?);
        }
        self.array(any)
    }

    fn table(&mut self, table: &Bound<'_, PyMapping>) -> PyResult<Value> {
        let mut data = Table::new();
        for entry in table.items()?.iter() {
            let (key, value): (Bound<'_, PyAny>, Bound<'_, PyAny>) = entry.extract()?;
            let Ok(key) = key.extract::<String>() else {
                return Err(self.unknown(&key, "a text as key"));
            };
            let length = self.path.len();
            self.path += if length == 0 { "" } else { "." };
            self.path += &key;
            let value = if key == "name" && value.is_callable() {
                Some(Value::String(self.callables.name(&value, &self.path, CallableRole::Force)))
            } else {
                self.read(&value)?
            };
            self.path.truncate(length);
            data.extend(value.map(|value| (key, value)));
        }
        Ok(Value::Table(data))
    }

    fn array(&mut self, any: &Bound<'_, PyAny>) -> PyResult<Value> {
        let Ok(items) = any.cast::<PySequence>() else {
            return Err(self.unknown(any, "a number, a text, a sequence or a table"));
        };
        let mut data = Vec::new();
        for (i, item) in items.try_iter()?.enumerate() {
            let length = self.path.len();
            self.path += &format!("[{i}]");
            data.push(self.value(&item?)?);
            self.path.truncate(length);
        }
        Ok(Value::Array(data))
    }

    fn unknown(&self, any: &Bound<'_, PyAny>, expected: &str) -> PyErr {
        let kind = any.get_type();
        let name = kind.name().map_or_else(|_| "?".to_owned(), |name| name.to_string());
        let place = if self.path.is_empty() { "the model" } else { &self.path };
        PyTypeError::new_err(format!("{place}: found an object of type {name}, expected {expected}"))
    }
}

/// Returns the data of an external function of time.
fn external(name: String) -> Value {
    Value::Table(Table::from_iter([("kind".into(), "external".into()), ("name".into(), name.into())]))
}

/// Returns an integer. Integers beyond 64 bits become floating-point numbers, as in files.
fn integer(any: &Bound<'_, PyAny>) -> PyResult<Value> {
    match any.extract::<i64>() {
        Ok(n) => Ok(Value::Integer(n)),
        Err(_) => Ok(Value::Float(any.extract()?)),
    }
}

/// Returns the data of an object.
pub(crate) fn read_table(any: &Bound<'_, PyAny>) -> PyResult<Value> {
    DataReader::default().model(any)
}

/// Converts data to dictionaries, lists and numbers of Python.
pub(crate) fn to_python<'py>(py: Python<'py>, value: &Value) -> PyResult<Bound<'py, PyAny>> {
    to_python_with(py, value, &Callables::default())
}

/// Converts data to Python, with callables in place of their names.
pub(crate) fn to_python_with<'py>(
    py: Python<'py>,
    value: &Value,
    callables: &Callables,
) -> PyResult<Bound<'py, PyAny>> {
    match value {
        Value::String(text) => text.into_bound_py_any(py),
        Value::Integer(n) => n.into_bound_py_any(py),
        Value::Float(x) => x.into_bound_py_any(py),
        Value::Boolean(yes) => yes.into_bound_py_any(py),
        Value::Datetime(date) => date.to_string().into_bound_py_any(py),
        Value::Array(items) => {
            let items: Vec<_> =
                items.iter().map(|item| to_python_with(py, item, callables)).collect::<PyResult<_>>()?;
            Ok(PyList::new(py, items)?.into_any())
        }
        Value::Table(table)
            if table.len() == 2 && callables.function(table, CallableRole::Time).is_some() =>
        {
            callables.function(table, CallableRole::Time).into_bound_py_any(py)
        }
        Value::Table(table) => {
            let dict = PyDict::new(py);
            for (key, value) in table {
                dict.set_item(key, to_python_with(py, value, callables)?)?;
            }
            if let Some(force) = callables.function(table, CallableRole::Force) {
                dict.set_item("name", force)?;
            }
            Ok(dict.into_any())
        }
    }
}
