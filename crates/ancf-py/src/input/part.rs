//! Parts of a model by their definitions in the schema.

use pyo3::prelude::*;
use serde::de::DeserializeOwned;

use super::data::read_table;
use super::errors::{model_error, value_error};

/// Checks a part of a model by its definition in the schema. Raises `ModelError` with all errors.
#[pyfunction]
pub(crate) fn check_part(definition: &str, data: &Bound<'_, PyAny>) -> PyResult<()> {
    ancf::reading::check_part(definition, &read_table(data)?)
        .map_err(|errors| model_error(data.py(), &errors, None))
}

/// Checks a part of a model by its definition and returns it.
pub(crate) fn deserialize_part<T: DeserializeOwned>(
    definition: &str,
    data: &Bound<'_, PyAny>,
) -> PyResult<T> {
    let value = read_table(data)?;
    ancf::reading::check_part(definition, &value).map_err(|errors| model_error(data.py(), &errors, None))?;
    value.try_into().map_err(|error: toml::de::Error| value_error(error))
}
