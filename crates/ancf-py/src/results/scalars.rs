//! Scalar fields of the report: section forces, stresses and strain along the bodies.

use std::sync::Arc;

use ancf_report::fields::{ScalarField, ScalarFields};
use ancf_report::geometry::Geometry;
use ancf_surface::BodySurfaces;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;

use crate::input::detached;
use crate::input::{DataReader, Signals, valid_model};
use crate::run::{FIELD_MEMORY, States, checked_parts};

/// Name, unit or empty text, true for values of both signs, values `[frame, station]`.
type Scalars<'py> = (&'static str, String, bool, Bound<'py, PyArray2<f64>>);

/// Returns the scalar fields by which the report colours bodies, in all or some frames.
#[pyfunction]
#[pyo3(signature = (states, parts, frames=None))]
pub(crate) fn scalar_fields<'py>(
    states: &Bound<'py, States>,
    parts: i64,
    frames: Option<Vec<usize>>,
) -> PyResult<Vec<Scalars<'py>>> {
    let py = states.py();
    let states = states.get();
    let frames = states.checked_frames(frames)?;
    states.require("stress", false)?;
    let parts = checked_parts(parts)?;
    let model = valid_model(py, &DataReader::default().model(states.model.bind(py))?)?;
    let simulation = Arc::clone(&states.simulation);
    let signals = Signals::default();
    let (fields, stations) = detached(py, || {
        let (assembly, scales) = (simulation.assembly(), simulation.scales());
        let geometry = Geometry::new(&model, assembly, scales, &BodySurfaces::default(), parts, 1.0);
        let reference = geometry.place(&assembly.rest());
        let mut fields = ScalarFields::new(&model, assembly, scales, &geometry, &[]);
        states.each(&frames, |s| {
            fields.push(&geometry, s, &[&geometry.place(s)], &reference);
            !signals.are_set()
        });
        (fields.into_defined(), geometry.stations())
    });
    if let Some(error) = signals.take() {
        return Err(error);
    }
    let of = |field: ScalarField| {
        let mut values = Vec::new();
        values.try_reserve_exact(field.values.len()).map_err(|_| PyMemoryError::new_err(FIELD_MEMORY))?;
        values.extend(field.values.iter().copied().map(f64::from));
        let values = PyArray1::from_vec(py, values).reshape([frames.len(), stations])?;
        let unit = model.units.as_ref().map_or_else(String::new, |units| units.of(field.dimension));
        Ok((field.name, unit, field.diverging, values))
    };
    fields.into_iter().map(of).collect()
}
