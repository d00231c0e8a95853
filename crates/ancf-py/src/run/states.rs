//! States of a run for Python.

use std::sync::Arc;

use ancf::solver::equations::State;
use ancf::{Field, Fields, Simulation};
use numpy::{PyArray1, PyArray3, PyArrayMethods};
use pyo3::exceptions::{PyIndexError, PyMemoryError, PyValueError};
use pyo3::prelude::*;

use super::frames::Frames;
use super::keep::Keep;
use crate::input::Signals;

/// States of a run, from which fields are computed.
#[pyclass(frozen, module = "ancf._ancf")]
#[derive(Debug)]
pub(crate) struct States {
    pub(crate) simulation: Arc<Simulation>,
    /// Model as plain data, from which another process creates the same simulation.
    pub(crate) model: Py<PyAny>,
    /// Text of the model file, if known.
    pub(crate) text: Option<String>,
    frames: Frames,
}

/// Message about a field that does not fit into memory.
const FIELD_MEMORY: &str = "the field does not fit into memory; `rows=` and fewer `parts` need less";
/// Maximum number of parts of an element.
const MAX_PARTS: u32 = 1000;

/// Checks the number of parts of an element.
fn checked(parts: i64) -> PyResult<u32> {
    let known = u32::try_from(parts).ok().filter(|parts| (1..=MAX_PARTS).contains(parts));
    let wanted = || format!("parts: found {parts}, wanted an integer from 1 to {MAX_PARTS}");
    known.ok_or_else(|| PyValueError::new_err(wanted()))
}

impl States {
    pub(crate) fn new(simulation: &Arc<Simulation>, model: Py<PyAny>, frames: Frames) -> Self {
        Self { simulation: Arc::clone(simulation), model, text: None, frames }
    }

    /// Sets the text of the model file.
    pub(crate) fn with_text(self, text: Option<String>) -> Self {
        Self { text, ..self }
    }

    /// Returns a state. Without velocities, only its coordinates are those of the run.
    ///
    /// # Errors
    /// If it was not kept.
    pub(crate) fn state(&self, frame: usize, needs_velocities: bool) -> PyResult<State> {
        let keeps_enough = match self.frames.keep {
            Keep::All => true,
            Keep::Positions => !needs_velocities,
            Keep::Nothing => false,
        };
        if !keeps_enough {
            return Err(PyValueError::new_err(missing_states("positions of joints", "states=\"all\"")));
        }
        if frame >= self.frames.len() {
            return Err(PyIndexError::new_err(format!("state {frame} of {}", self.frames.len())));
        }
        let mut state = self.simulation.assembly().rest();
        self.frames.each(&[frame], state.clone(), |s| {
            state.clone_from(s);
            true
        });
        Ok(state)
    }

    /// Returns all states.
    ///
    /// # Errors
    /// If complete states were not kept, or if they do not fit into memory.
    pub(crate) fn all(&self) -> PyResult<Vec<State>> {
        if self.frames.keep != Keep::All {
            return Err(PyValueError::new_err(missing_states("report", "states=\"all\"")));
        }
        let mut states = Vec::new();
        let count = self.frames.len();
        states.try_reserve_exact(count).map_err(|_| PyMemoryError::new_err("no memory for the states"))?;
        let numbers: Vec<usize> = (0..count).collect();
        self.frames.each(&numbers, self.simulation.assembly().rest(), |s| {
            states.push(s.clone());
            true
        });
        Ok(states)
    }
}

/// Returns the message about states that were not kept.
fn missing_states(what: &str, wanted: &str) -> String {
    let file = "of a run by the command line, by a model with `output.states` > 0";
    format!("{what}: the run kept no such states; run it with {wanted}; {file}")
}

/// Arguments of the function `states`: model, text, kept part, times and load factors, all numbers.
type Pickled<'py> =
    (Py<PyAny>, Option<&'py str>, &'static str, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>);

#[pymethods]
impl States {
    /// Computes a field at the stations along all bodies in all or some frames: [frame, station, number].
    #[pyo3(signature = (name, parts, frames=None))]
    fn field<'py>(
        &self,
        py: Python<'py>,
        name: &str,
        parts: i64,
        frames: Option<Vec<usize>>,
    ) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let count = self.frames.len();
        let frames = frames.unwrap_or_else(|| (0..count).collect());
        if let Some(frame) = frames.iter().find(|frame| **frame >= count) {
            return Err(PyIndexError::new_err(format!("state {frame} of {count}")));
        }
        let Some((_, field)) = Field::ALL.into_iter().find(|(own, _)| *own == name) else {
            let names: Vec<_> = Field::ALL.iter().map(|(name, _)| format!("{name:?}")).collect();
            let (found, wanted) = (name, names.join(", "));
            return Err(PyValueError::new_err(format!("field: found {found:?}, wanted one of {wanted}")));
        };
        let is_positional = matches!(field, Field::Position | Field::Displacement | Field::Directors);
        let wanted = match self.frames.keep {
            Keep::All => None,
            Keep::Positions if is_positional => None,
            Keep::Positions => Some("states=\"all\""),
            Keep::Nothing => Some("states=\"all\" or \"positions\""),
        };
        if let Some(wanted) = wanted {
            return Err(PyValueError::new_err(missing_states(&format!("field {name:?}"), wanted)));
        }
        let parts = checked(parts)?;
        let signals = Signals::default();
        let (numbers, stations) = py.detach(|| {
            let fields = Fields::new(self.simulation.assembly(), self.simulation.scales(), parts);
            let stations = fields.stations().len();
            let mut numbers = Vec::new();
            let count = frames.len().saturating_mul(stations).saturating_mul(field.width());
            numbers.try_reserve_exact(count).map_err(|_| PyMemoryError::new_err(FIELD_MEMORY))?;
            self.frames.each(&frames, self.simulation.assembly().rest(), |s| {
                fields.fill(field, s, &mut numbers);
                !signals.are_set()
            });
            Ok::<_, PyErr>((numbers, stations))
        })?;
        if let Some(error) = signals.take() {
            return Err(error);
        }
        PyArray1::from_vec(py, numbers).reshape([frames.len(), stations, field.width()])
    }

    /// Returns the names of the bodies, and body number and arc length of each station.
    fn stations(&self, parts: i64) -> PyResult<(Vec<String>, Vec<usize>, Vec<f64>)> {
        let parts = checked(parts)?;
        let assembly = self.simulation.assembly();
        let names = assembly.bodies().map(|(name, _)| name.to_owned()).collect();
        let fields = Fields::new(assembly, self.simulation.scales(), parts);
        let (bodies, lengths) = fields.stations().iter().map(|station| (station.body, station.s)).unzip();
        Ok((names, bodies, lengths))
    }

    /// Pickles the states as arguments of the function `states`.
    fn __reduce__<'py>(&'py self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Pickled<'py>)> {
        let make = py.import("ancf._ancf")?.getattr("states")?;
        let Frames { keep, at, numbers } = &self.frames;
        let (at, numbers) = (PyArray1::from_slice(py, at.as_flattened()), PyArray1::from_slice(py, numbers));
        Ok((make, (self.model.clone_ref(py), self.text.as_deref(), keep.word(), at, numbers)))
    }

    /// Number of states.
    fn __len__(&self) -> usize {
        self.frames.len()
    }
}
