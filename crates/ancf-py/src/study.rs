//! Functions of the study engine: sampling, numbering of cases, checks of parameters, types of columns, evaluation.

use ancf_study::{CaseLayout, ParameterType, Sampling};
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::{PyIndexError, PyTypeError};
use pyo3::prelude::*;
use serde::Deserialize;
use serde::de::IntoDeserializer;
use serde::de::value::Error;

use crate::input::detached;
use crate::input::{DataReader, FaultArguments, faults, to_python_with, value_error};

/// Returns the variant with a name of study files.
fn variant<'a, T: Deserialize<'a>>(name: &'a str) -> PyResult<T> {
    T::deserialize(name.into_deserializer()).map_err(|error: Error| value_error(error))
}

/// Converts rows of equal length to an array `[row, column]`.
fn rows_to_array<'py>(
    py: Python<'py>,
    rows: &[Vec<f64>],
    columns: u32,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    PyArray1::from_vec(py, rows.concat()).reshape([rows.len(), columns as usize])
}

/// Returns the probabilities whose quantiles are the samples of parameters, `[parameter, sample]`.
#[pyfunction]
pub(crate) fn sample_probabilities<'py>(
    py: Python<'py>,
    sampling: &str,
    count: u32,
    seed: u32,
    parameters: Vec<String>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let sampling: Sampling = variant(sampling)?;
    let parameters: Vec<&str> = parameters.iter().map(String::as_str).collect();
    rows_to_array(py, &detached(py, || sampling.probabilities(count, seed, &parameters)), count)
}

/// Returns the first points of a scrambled Sobol sequence, `[dimension, point]`.
#[pyfunction]
pub(crate) fn sobol_points(
    py: Python<'_>,
    dimension: usize,
    count: u32,
    seed: u32,
) -> PyResult<Bound<'_, PyArray2<f64>>> {
    rows_to_array(py, &detached(py, || ancf_study::sobol_points(dimension, count, seed)), count)
}

/// Returns the strides of parameters and the number of cases, or `None` if it cannot be represented.
///
/// The length of a list of values is a number, the length of a distribution is `None`.
#[pyfunction]
pub(crate) fn case_layout(
    lengths: Vec<Option<usize>>,
    samples: usize,
    combine: &str,
) -> PyResult<Option<(Vec<usize>, usize)>> {
    let layout = CaseLayout::new(&lengths, samples, variant(combine)?);
    Ok(layout.map(|layout| (layout.strides, layout.cases)))
}

/// Returns the errors of zipped lists of different lengths: path and length of each list.
#[pyfunction]
pub(crate) fn zip_errors(lists: Vec<(String, usize)>) -> Vec<FaultArguments> {
    faults(&ancf_study::zip_errors(&lists))
}

/// Returns the data of a model with the first value of each parameter, and the errors of the paths.
#[pyfunction]
pub(crate) fn check_places<'py>(
    base: &Bound<'py, PyAny>,
    first_values: Vec<(String, Bound<'py, PyAny>)>,
) -> PyResult<(Bound<'py, PyAny>, Vec<FaultArguments>)> {
    let mut reader = DataReader::default();
    let model = reader.model(base)?;
    let mut values = Vec::new();
    for (path, value) in first_values {
        reader.begin_at(&path);
        let Some(value) = reader.read(&value)? else {
            return Err(PyTypeError::new_err(format!("{path}: found None, expected a value")));
        };
        values.push((path, value));
    }
    let (data, errors) = ancf_study::check_places(&values, &model);
    Ok((to_python_with(base.py(), &data, &reader.callables)?, faults(&errors)))
}

/// Reduces a column to one number. Raises `IndexError` for an empty column.
#[pyfunction]
pub(crate) fn reduce_column(column: PyReadonlyArray1<'_, f64>, take: &str) -> PyResult<f64> {
    let reduced = ancf_study::reduce_column(column.as_array().iter().copied(), variant(take)?);
    reduced.ok_or_else(|| PyIndexError::new_err("a column without rows"))
}

/// Returns the Arrow type of the column of a parameter. Values that are no data are text.
#[pyfunction]
pub(crate) fn parameter_type(values: Vec<Bound<'_, PyAny>>) -> &'static str {
    let mut reader = DataReader::default();
    let values: Option<Vec<_>> = values.iter().map(|value| reader.read(value).ok().flatten()).collect();
    values.map_or(ParameterType::Text, |values| ParameterType::of(&values)).arrow_name()
}

/// Returns the observed orders and the limits of values at decreasing sizes; NaN without an order.
#[pyfunction]
pub(crate) fn observed_orders<'py>(
    py: Python<'py>,
    sizes: Vec<f64>,
    values: Vec<f64>,
) -> (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>) {
    let (orders, limits) = ancf_study::observed_orders(&sizes, &values);
    (PyArray1::from_vec(py, orders), PyArray1::from_vec(py, limits))
}

/// Returns the standardised coefficients of a linear regression on columns, the rank correlations, and the explained fraction of
/// the variance. `None` for constant values.
#[pyfunction]
pub(crate) fn linear_fit(columns: Vec<Vec<f64>>, values: Vec<f64>) -> Option<(Vec<f64>, Vec<f64>, f64)> {
    let fit = ancf_study::linear_fit(&columns, &values)?;
    Some((fit.coefficients, fit.ranks, fit.explained))
}
