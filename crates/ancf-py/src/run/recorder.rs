//! Recorder of rows and states of a run.

use std::collections::TryReserveError;
use std::io;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use ancf::Observer;
use ancf::solver::equations::State;
use numpy::PyArray1;
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;
use pyo3::types::PyList;

use super::frames::Frames;
use super::keep::Keep;
use super::states::{AssembledModel, States};
use crate::input::Signals;

/// Simulation of a run with its settings.
pub(crate) struct RecordedSimulation {
    pub(crate) assembled: AssembledModel,
    /// Model as plain data.
    pub(crate) model: Py<PyAny>,
    pub(crate) signals: Signals,
    /// Number of steps per kept row. The last step is kept too.
    pub(crate) every: u32,
}

/// Records rows and states of a run, and calls callbacks of Python.
pub(crate) struct RunRecorder {
    pub(crate) columns: Vec<String>,
    pub(crate) rows: Vec<f64>,
    pub(crate) frames: Frames,
    of: RecordedSimulation,
    /// Number of rows so far, including rows that were not kept.
    count: u32,
    callback: Option<Py<PyAny>>,
    tick: Option<Py<PyAny>>,
    ticked: Option<Instant>,
    /// Names of the columns for the callback.
    names: Option<Py<PyList>>,
}

/// Minimum time between two ticks.
const TICK: Duration = Duration::from_millis(100);

impl RunRecorder {
    /// Creates a recorder that calls `callback(columns, row, states)` with each row and `tick(first)` now and then with the first
    /// number of a row. A true return value ends the run.
    pub(crate) fn new(of: RecordedSimulation, keep: Keep, [callback, tick]: [Option<Py<PyAny>>; 2]) -> Self {
        Self {
            columns: Vec::new(),
            rows: Vec::new(),
            frames: Frames::new(keep),
            of,
            count: 0,
            callback,
            tick,
            ticked: None,
            names: None,
        }
    }

    /// Keeps a row and its state if due.
    fn keep(&mut self, row: &[f64], state: &State) -> Result<(), TryReserveError> {
        // The previous row was kept only because it could have been the last.
        if self.count > 0 && !(self.count - 1).is_multiple_of(self.of.every) {
            self.rows.truncate(self.rows.len() - row.len());
            self.frames.pop();
        }
        self.rows.try_reserve(row.len())?;
        self.frames.push(state)?;
        self.rows.extend_from_slice(row);
        self.count += 1;
        Ok(())
    }

    /// Calls the callbacks. Returns true if one of them ends the run.
    fn call_back(&mut self, row: &[f64], state: &State) -> PyResult<bool> {
        let mut wants_end = false;
        if let Some(callback) = &self.callback {
            let mut frames = Frames::new(Keep::All);
            frames.push(state).map_err(|_| PyMemoryError::new_err("no memory for a state"))?;
            wants_end |= Python::attach(|py| {
                let states = States::new(&self.of.assembled, self.of.model.clone_ref(py), frames);
                callback.call1(py, (&self.names, PyArray1::from_slice(py, row), states))?.is_truthy(py)
            })?;
        }
        if self.ticked.is_none_or(|ticked| ticked.elapsed() >= TICK)
            && let (Some(tick), Some(first)) = (&self.tick, row.first())
        {
            self.ticked = Some(Instant::now());
            wants_end |= Python::attach(|py| tick.call1(py, (*first,))?.is_truthy(py))?;
        }
        Ok(wants_end)
    }
}

impl Observer for RunRecorder {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        self.columns = columns.to_vec();
        if self.callback.is_some() {
            let names = Python::attach(|py| PyList::new(py, columns).map(Bound::unbind));
            self.names = Some(names.map_err(io::Error::other)?);
        }
        Ok(())
    }

    fn record(&mut self, row: &[f64], state: &State) -> io::Result<ControlFlow<()>> {
        self.keep(row, state).map_err(|_| io::Error::from(io::ErrorKind::OutOfMemory))?;
        match self.call_back(row, state) {
            Ok(false) => Ok(ControlFlow::Continue(())),
            Ok(true) => Ok(ControlFlow::Break(())),
            Err(error) => {
                self.of.signals.raise(error);
                Ok(ControlFlow::Break(()))
            }
        }
    }

    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}
