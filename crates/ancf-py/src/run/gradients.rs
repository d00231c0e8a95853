//! Gradients as NumPy arrays.

use ancf::Gradients;
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::linear::array;

/// Returns gradients in a dictionary.
pub(super) fn gradients_data<'py>(py: Python<'py>, found: &Gradients) -> PyResult<Bound<'py, PyDict>> {
    let data = PyDict::new(py);
    data.set_item("quantities", &found.quantities)?;
    data.set_item("values", PyArray1::from_slice(py, &found.values))?;
    data.set_item("parameters", &found.parameters)?;
    data.set_item("parameter_values", PyArray1::from_slice(py, &found.parameter_values))?;
    data.set_item("derivatives", array(py, &found.derivatives)?)?;
    data.set_item("errors", array(py, &found.errors)?)?;
    data.set_item("warnings", &found.warnings)?;
    Ok(data)
}
