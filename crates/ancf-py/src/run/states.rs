//! States of a run for Python.

use std::collections::HashMap;
use std::sync::Arc;

use ancf::solver::equations::State;
use ancf::{Fields, GivenState, Simulation};
use ancf_surface::BodySurfaces;
use numpy::{PyArray1, PyArray3, PyArrayMethods};
use pyo3::exceptions::{PyIndexError, PyMemoryError, PyValueError};
use pyo3::prelude::*;

use super::frames::Frames;
use super::keep::Keep;
use super::station_quantity::StationQuantity;
use crate::input::Signals;
use crate::input::detached;

/// Simulation of a model, and the surfaces of its rigid bodies.
#[derive(Clone, Debug)]
pub(crate) struct AssembledModel {
    pub(crate) simulation: Arc<Simulation>,
    pub(crate) surfaces: Arc<BodySurfaces>,
}

/// States of a run, from which fields are computed.
#[pyclass(frozen, module = "ancf._ancf")]
#[derive(Debug)]
pub(crate) struct States {
    pub(crate) simulation: Arc<Simulation>,
    /// Surfaces of the rigid bodies.
    pub(crate) surfaces: Arc<BodySurfaces>,
    /// Model as plain data, from which another process creates the same simulation.
    pub(crate) model: Py<PyAny>,
    /// Text of the model file, if known.
    pub(crate) text: Option<String>,
    frames: Frames,
}

/// Message about a field that does not fit into memory.
pub(crate) const FIELD_MEMORY: &str =
    "the field does not fit into memory; `rows=` and fewer `parts` need less";
/// Maximum number of parts of an element.
const MAX_PARTS: u32 = 1000;

/// Checks the number of parts of an element.
pub(crate) fn checked_parts(parts: i64) -> PyResult<u32> {
    let known = u32::try_from(parts).ok().filter(|parts| (1..=MAX_PARTS).contains(parts));
    let expected = || format!("parts: found {parts}, expected an integer from 1 to {MAX_PARTS}");
    known.ok_or_else(|| PyValueError::new_err(expected()))
}

impl States {
    pub(crate) fn new(of: &AssembledModel, model: Py<PyAny>, frames: Frames) -> Self {
        let AssembledModel { simulation, surfaces } = of.clone();
        Self { simulation, surfaces, model, text: None, frames }
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

    /// Returns the last state, in which another run may start. `row` has the turns of angles by their columns.
    ///
    /// # Errors
    /// If complete states were not kept.
    pub(crate) fn last(&self, row: &HashMap<String, f64>) -> PyResult<GivenState> {
        let state = self.state(self.frames.len().saturating_sub(1), true)?;
        let given = self.simulation.given_state(&state, "the last state of the analysis before".to_owned());
        let counted = self.simulation.counted_angles().into_iter();
        Ok(given.with_angles(counted.filter_map(|name| row.get(&name).map(|value| (name.clone(), *value)))))
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
fn missing_states(what: &str, expected: &str) -> String {
    let file = "of a run by the command line, by a model with `output.states` > 0";
    format!("{what}: the run kept no such states; run it with {expected}; {file}")
}

impl States {
    /// Numbers of frames: all by default.
    ///
    /// # Errors
    /// If a frame does not exist.
    pub(crate) fn checked_frames(&self, frames: Option<Vec<usize>>) -> PyResult<Vec<usize>> {
        let count = self.frames.len();
        let frames = frames.unwrap_or_else(|| (0..count).collect());
        match frames.iter().find(|frame| **frame >= count) {
            Some(frame) => Err(PyIndexError::new_err(format!("state {frame} of {count}"))),
            None => Ok(frames),
        }
    }

    /// Checks that the states have what a quantity needs: positions, or velocities too.
    pub(crate) fn require(&self, what: &str, is_positional: bool) -> PyResult<()> {
        let expected = match self.frames.keep {
            Keep::All => return Ok(()),
            Keep::Positions if is_positional => return Ok(()),
            Keep::Positions => "states=\"all\"",
            Keep::Nothing => "states=\"all\" or \"positions\"",
        };
        Err(PyValueError::new_err(missing_states(what, expected)))
    }

    /// Calls `see` with the states of the given numbers until it returns false.
    pub(crate) fn each(&self, frames: &[usize], see: impl FnMut(&State) -> bool) {
        self.frames.each(frames, self.simulation.assembly().rest(), see);
    }
}

/// Arguments of the function `states`: model, text, kept part, times and load factors, all numbers.
type Pickled<'py> =
    (Py<PyAny>, Option<&'py str>, &'static str, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>);

#[pymethods]
impl States {
    /// Computes a field at the stations along all bodies in all or some frames: [frame, station, number].
    ///
    /// Strains and stresses are those at an offset (y, z) of the section; on the axis by default.
    #[pyo3(signature = (name, parts, frames=None, offset=None))]
    fn field<'py>(
        &self,
        py: Python<'py>,
        name: &str,
        parts: i64,
        frames: Option<Vec<usize>>,
        offset: Option<[f64; 2]>,
    ) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let frames = self.checked_frames(frames)?;
        let quantity = StationQuantity::from_name(name, offset.unwrap_or_default())?;
        self.require(&format!("field {name:?}"), quantity.is_positional(&self.simulation))?;
        let parts = checked_parts(parts)?;
        let signals = Signals::default();
        let (numbers, stations) = detached(py, || {
            let fields = Fields::new(self.simulation.assembly(), self.simulation.scales(), parts);
            let stations = fields.stations().len();
            let mut numbers = Vec::new();
            let count = frames.len().saturating_mul(stations).saturating_mul(quantity.width());
            numbers.try_reserve_exact(count).map_err(|_| PyMemoryError::new_err(FIELD_MEMORY))?;
            // Forces and stresses are those of the state about which a shape vibrates.
            let is_still = self.simulation.has_shapes() && !quantity.is_rate();
            self.each(&frames, |s| {
                let still = is_still.then(|| {
                    let mut still = s.clone();
                    still.stop();
                    still
                });
                quantity.fill(&self.simulation, &fields, still.as_ref().unwrap_or(s), &mut numbers);
                !signals.are_set()
            });
            Ok::<_, PyErr>((numbers, stations))
        })?;
        if let Some(error) = signals.take() {
            return Err(error);
        }
        PyArray1::from_vec(py, numbers).reshape([frames.len(), stations, quantity.width()])
    }

    /// Returns the names of the bodies, and body number and arc length of each station.
    fn stations(&self, parts: i64) -> PyResult<(Vec<String>, Vec<usize>, Vec<f64>)> {
        let parts = checked_parts(parts)?;
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

    /// Number of states and of the kept parts.
    fn __repr__(&self) -> String {
        format!("States({}, {})", self.frames.len(), self.frames.keep.word())
    }

    /// Number of states.
    fn __len__(&self) -> usize {
        self.frames.len()
    }
}
