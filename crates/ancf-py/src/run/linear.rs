//! Linear models as NumPy arrays.

use ancf::LinearModel;
use ancf::nalgebra::DMatrix;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Returns a linear model in a dictionary.
pub(super) fn linear_data<'py>(py: Python<'py>, model: &LinearModel) -> PyResult<Bound<'py, PyDict>> {
    let data = PyDict::new(py);
    let form = &model.descriptor;
    let matrices = [
        ("A", &model.a),
        ("B", &model.b),
        ("C", &model.c),
        ("D", &model.d),
        ("basis", &model.basis),
        ("projection", &model.projection),
        ("mass", &form.mass),
        ("damping", &form.damping),
        ("stiffness", &form.stiffness),
        ("constraints", &form.constraints),
        ("forces", &form.inputs),
    ];
    for (name, matrix) in matrices {
        data.set_item(name, array(py, matrix)?)?;
    }
    let vectors = [
        ("rate", model.rate.as_slice()),
        ("input_values", &model.input_values),
        ("output_values", &model.output_values),
        ("coordinates", &model.coordinates),
        ("velocities", &model.velocities),
    ];
    for (name, numbers) in vectors {
        data.set_item(name, PyArray1::from_slice(py, numbers))?;
    }
    data.set_item("inputs", &model.inputs)?;
    data.set_item("outputs", &model.outputs)?;
    data.set_item("time", model.time)?;
    data.set_item("warnings", &model.warnings)?;
    Ok(data)
}

pub(super) fn array<'py>(py: Python<'py>, matrix: &DMatrix<f64>) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let (rows, columns) = matrix.shape();
    let numbers = matrix.transpose().as_slice().to_vec();
    PyArray1::from_vec(py, numbers).reshape([rows, columns])
}
