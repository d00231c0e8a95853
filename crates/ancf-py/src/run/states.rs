use std::collections::TryReserveError;
use std::sync::Arc;

use ancf::system::State;
use ancf::{Field, Fields, Simulation};
use numpy::{PyArray1, PyArray3, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::{PyIndexError, PyMemoryError, PyValueError};
use pyo3::prelude::*;

use crate::run;
use crate::signals::Signals;

/// States of a run, from which fields are read.
#[pyclass(frozen, module = "ancf._ancf")]
#[derive(Debug)]
pub(crate) struct States {
    pub(crate) simulation: Arc<Simulation>,
    /// The model as plain data, by which another process makes the same simulation.
    pub(crate) model: Py<PyAny>,
    /// The text of the model's file, if it is known.
    pub(crate) text: Option<String>,
    frames: Frames,
}

/// Said when a field does not fit.
const FIELD: &str = "the field does not fit into memory; `rows=` and fewer `parts` need less";
/// Parts of an element that nobody needs more of.
const MOST_PARTS: u32 = 1000;

fn checked(parts: i64) -> PyResult<u32> {
    let known = u32::try_from(parts).ok().filter(|parts| (1..=MOST_PARTS).contains(parts));
    let wanted = || format!("parts: found {parts}, wanted an integer from 1 to {MOST_PARTS}");
    known.ok_or_else(|| PyValueError::new_err(wanted()))
}

/// What is kept of a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Keep {
    All,
    Positions,
    Nothing,
}

impl Keep {
    const fn name(self) -> &'static str {
        match self {
            Self::All => "all",
            Self::Positions => "positions",
            Self::Nothing => "none",
        }
    }

    pub(crate) fn named(name: &str) -> PyResult<Self> {
        match name {
            "all" => Ok(Self::All),
            "positions" => Ok(Self::Positions),
            "none" => Ok(Self::Nothing),
            _ => Err(PyValueError::new_err(format!(
                "states: found {name:?}, wanted \"all\", \"positions\" or \"none\""
            ))),
        }
    }
}

/// Frames one after the other: of each, time and load factor, and so many coordinates, or these with velocities, accelerations
/// and multipliers.
#[derive(Clone, Debug)]
pub(crate) struct Frames {
    keep: Keep,
    at: Vec<[f64; 2]>,
    numbers: Vec<f64>,
}

impl Frames {
    pub(crate) const fn new(keep: Keep) -> Self {
        Self { keep, at: Vec::new(), numbers: Vec::new() }
    }

    /// Adds a frame.
    ///
    /// # Errors
    /// If it does not fit into memory.
    pub(crate) fn push(&mut self, s: &State) -> Result<(), TryReserveError> {
        let kept: &[&[f64]] = match self.keep {
            Keep::All => &[&s.q, &s.v, &s.a, &s.lambda],
            Keep::Positions => &[&s.q],
            Keep::Nothing => return Ok(()),
        };
        self.at.try_reserve(1)?;
        self.numbers.try_reserve(kept.iter().map(|numbers| numbers.len()).sum())?;
        self.at.push([s.t, s.load]);
        kept.iter().for_each(|numbers| self.numbers.extend_from_slice(numbers));
        Ok(())
    }

    /// Takes the last frame out.
    pub(crate) fn pop(&mut self) {
        if let Some(width) = self.numbers.len().checked_div(self.at.len()) {
            self.numbers.truncate(self.numbers.len() - width);
            self.at.pop();
        }
    }

    /// Numbers of a frame.
    fn width(keep: Keep, s: &State) -> usize {
        match keep {
            Keep::All => 3 * s.q.len() + s.lambda.len(),
            Keep::Positions => s.q.len(),
            Keep::Nothing => 0,
        }
    }

    /// Frames of these numbers as states, one after the other in the same place.
    fn each(&self, frames: &[usize], mut s: State, mut see: impl FnMut(&State) -> bool) {
        let width = Self::width(self.keep, &s);
        for &frame in frames {
            let mut numbers = &self.numbers[frame * width..][..width];
            [s.t, s.load] = self.at[frame];
            for part in [&mut s.q, &mut s.v, &mut s.a, &mut s.lambda] {
                let Some((own, rest)) = numbers.split_at_checked(part.len()) else { break };
                part.copy_from_slice(own);
                numbers = rest;
            }
            if !see(&s) {
                return;
            }
        }
    }
}

impl States {
    pub(crate) fn new(simulation: &Arc<Simulation>, model: Py<PyAny>, frames: Frames) -> Self {
        Self { simulation: Arc::clone(simulation), model, text: None, frames }
    }

    /// The same, of a model whose file reads so.
    pub(crate) fn with_text(self, text: Option<String>) -> Self {
        Self { text, ..self }
    }

    /// All states, of which everything must have been kept.
    ///
    /// # Errors
    /// If it was not, or if they do not fit into memory.
    pub(crate) fn all(&self) -> PyResult<Vec<State>> {
        if self.frames.keep != Keep::All {
            return Err(PyValueError::new_err(lacking("report", "states=\"all\"")));
        }
        let mut states = Vec::new();
        let count = self.frames.at.len();
        states.try_reserve_exact(count).map_err(|_| PyMemoryError::new_err("no memory for the states"))?;
        let numbers: Vec<usize> = (0..count).collect();
        self.frames.each(&numbers, self.simulation.assembly().rest(), |s| {
            states.push(s.clone());
            true
        });
        Ok(states)
    }
}

/// Said when states are wanted that were not kept.
fn lacking(what: &str, wanted: &str) -> String {
    let file = "of a run by the command line, by a model with `output.states` > 0";
    format!("{what}: the run kept no such states; run it with {wanted}; {file}")
}

/// The model, its text, what was kept, times and load factors, all numbers.
type Packed<'py> =
    (Py<PyAny>, Option<&'py str>, &'static str, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>);

/// States that were pickled.
#[pyfunction]
pub(crate) fn states(
    model: Bound<'_, PyAny>,
    text: Option<String>,
    keep: &str,
    at: PyReadonlyArray1<'_, f64>,
    numbers: PyReadonlyArray1<'_, f64>,
) -> PyResult<States> {
    let simulation = run::Simulation::new(&model)?;
    let at = at.as_slice()?.as_chunks().0.to_vec();
    let frames = Frames { keep: Keep::named(keep)?, at, numbers: numbers.as_slice()?.to_vec() };
    let rest = simulation.simulation.assembly().rest();
    let wanted = Frames::width(frames.keep, &rest).saturating_mul(frames.at.len());
    if frames.numbers.len() != wanted {
        return Err(PyValueError::new_err("these states are not of this model"));
    }
    Ok(States::new(&simulation.simulation, model.unbind(), frames).with_text(text))
}

#[pymethods]
impl States {
    /// A field at the stations along all bodies, in all frames or in some: [frame, station, number].
    #[pyo3(signature = (name, parts, frames=None))]
    fn field<'py>(
        &self,
        py: Python<'py>,
        name: &str,
        parts: i64,
        frames: Option<Vec<usize>>,
    ) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let count = self.frames.at.len();
        let frames = frames.unwrap_or_else(|| (0..count).collect());
        if let Some(frame) = frames.iter().find(|frame| **frame >= count) {
            return Err(PyIndexError::new_err(format!("state {frame} of {count}")));
        }
        let Some((_, field)) = Field::ALL.into_iter().find(|(own, _)| *own == name) else {
            let names: Vec<_> = Field::ALL.iter().map(|(name, _)| format!("{name:?}")).collect();
            let (found, wanted) = (name, names.join(", "));
            return Err(PyValueError::new_err(format!("field: found {found:?}, wanted one of {wanted}")));
        };
        let still = matches!(field, Field::Position | Field::Displacement | Field::Directors);
        let wanted = match self.frames.keep {
            Keep::All => None,
            Keep::Positions if still => None,
            Keep::Positions => Some("states=\"all\""),
            Keep::Nothing => Some("states=\"all\" or \"positions\""),
        };
        if let Some(wanted) = wanted {
            return Err(PyValueError::new_err(lacking(&format!("field {name:?}"), wanted)));
        }
        let parts = checked(parts)?;
        let signals = Signals::default();
        let (numbers, stations) = py.detach(|| {
            let fields = Fields::new(self.simulation.assembly(), self.simulation.scales(), parts);
            let stations = fields.stations().len();
            let mut numbers = Vec::new();
            let count = frames.len().saturating_mul(stations).saturating_mul(field.width());
            numbers.try_reserve_exact(count).map_err(|_| PyMemoryError::new_err(FIELD))?;
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

    /// Names of the bodies, and the body's number and the arc length of each station.
    fn stations(&self, parts: i64) -> PyResult<(Vec<String>, Vec<usize>, Vec<f64>)> {
        let parts = checked(parts)?;
        let assembly = self.simulation.assembly();
        let names = assembly.bodies().map(|(name, _)| name.to_owned()).collect();
        let fields = Fields::new(assembly, self.simulation.scales(), parts);
        let (bodies, lengths) = fields.stations().iter().map(|station| (station.body, station.s)).unzip();
        Ok((names, bodies, lengths))
    }

    /// How pickle makes them again: by `states` from the model and all numbers.
    fn __reduce__<'py>(&'py self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Packed<'py>)> {
        let make = py.import("ancf._ancf")?.getattr("states")?;
        let Frames { keep, at, numbers } = &self.frames;
        let (at, numbers) = (PyArray1::from_slice(py, at.as_flattened()), PyArray1::from_slice(py, numbers));
        Ok((make, (self.model.clone_ref(py), self.text.as_deref(), keep.name(), at, numbers)))
    }

    /// Number of frames.
    fn __len__(&self) -> usize {
        self.frames.at.len()
    }
}
