//! States from a pickle.

use std::path::Path;

use ancf_surface::BodySurfaces;
use numpy::PyReadonlyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use super::frames::Frames;
use super::keep::Keep;
use super::simulation::Simulation;
use super::states::States;

/// Returns pickled states.
#[pyfunction]
pub(crate) fn states(
    model: Bound<'_, PyAny>,
    text: Option<String>,
    keep: &str,
    at: PyReadonlyArray1<'_, f64>,
    numbers: PyReadonlyArray1<'_, f64>,
) -> PyResult<States> {
    // Another machine may lack the mesh files.
    let simulation = Simulation::with_surfaces(&model, |model| {
        Ok(BodySurfaces::read(model, Path::new("")).unwrap_or_default())
    })?;
    let at = at.as_slice()?.as_chunks().0.to_vec();
    let frames = Frames { keep: Keep::from_word(keep)?, at, numbers: numbers.as_slice()?.to_vec() };
    let rest = simulation.assembled.simulation.assembly().rest();
    let expected = Frames::width(frames.keep, &rest).saturating_mul(frames.len());
    if frames.numbers.len() != expected {
        return Err(PyValueError::new_err("these states are not of this model"));
    }
    Ok(States::new(&simulation.assembled, model.unbind(), frames).with_text(text))
}
