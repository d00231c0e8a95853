//! Parts of a model by their definitions in the schema.

use pyo3::prelude::*;
use serde::de::DeserializeOwned;

use super::data::read_table;
use super::errors::{model_error, part_error, value_error};

/// Checks a part of a model by its definition in the schema. Raises `ModelError` with all errors.
///
/// `part` is the label of the part in the messages.
#[pyfunction]
#[pyo3(signature = (definition, data, part=None))]
pub(crate) fn check_part(definition: &str, data: &Bound<'_, PyAny>, part: Option<&str>) -> PyResult<()> {
    ancf::reading::check_part(definition, &read_table(data)?)
        .map_err(|errors| part_error(data.py(), &errors, part))
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

/// Returns the candidate that a misspelt word or a word of another program means, if any.
#[pyfunction]
pub(crate) fn nearest(word: &str, candidates: Vec<String>) -> Option<String> {
    ancf::errors::nearest(word, candidates.iter().map(String::as_str)).map(str::to_owned)
}
