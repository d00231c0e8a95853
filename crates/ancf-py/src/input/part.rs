use pyo3::prelude::*;

use crate::data::table;
use crate::model::refused;

/// Checks a part of a model by its definition in the schema; raises `ModelError` with all that is wrong.
#[pyfunction]
pub(crate) fn check_part(definition: &str, data: &Bound<'_, PyAny>) -> PyResult<()> {
    ancf::model::check_part(definition, &table(data)?).map_err(|errors| refused(data.py(), &errors, None))
}
