use std::collections::TryReserveError;
use std::io;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::{Duration, Instant};

use ancf::system::State;
use ancf::{Observer, Simulation};
use numpy::PyArray1;
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;
use pyo3::types::PyList;

use crate::run;
use crate::signals::Signals;
use crate::states::{Frames, Keep, States};

/// Keeps rows and states of a run, and tells Python of them.
pub(crate) struct Follower {
    pub(crate) columns: Vec<String>,
    pub(crate) rows: Vec<f64>,
    pub(crate) frames: Frames,
    /// Keep every so many, and the last.
    every: u32,
    count: u32,
    simulation: Arc<Simulation>,
    model: Py<PyAny>,
    signals: Signals,
    callback: Option<Py<PyAny>>,
    tick: Option<Py<PyAny>>,
    ticked: Option<Instant>,
    /// The columns, for the callback.
    names: Option<Py<PyList>>,
}

/// Between two ticks.
const TICK: Duration = Duration::from_millis(100);

impl Follower {
    /// `callback(columns, row, states)` is called with each row, `tick(first)` now and then with the first number of a row; what
    /// returns true ends the run.
    pub(crate) fn new(
        of: &run::Simulation,
        py: Python<'_>,
        keep: Keep,
        [callback, tick]: [Option<Py<PyAny>>; 2],
    ) -> Self {
        Self {
            columns: Vec::new(),
            rows: Vec::new(),
            frames: Frames::new(keep),
            every: of.every.max(1),
            count: 0,
            simulation: Arc::clone(&of.simulation),
            model: of.model.clone_ref(py),
            signals: of.signals.clone(),
            callback,
            tick,
            ticked: None,
            names: None,
        }
    }

    fn keep(&mut self, row: &[f64], state: &State) -> Result<(), TryReserveError> {
        // What was not due was only kept in case it should be the last.
        if self.count > 0 && !(self.count - 1).is_multiple_of(self.every) {
            self.rows.truncate(self.rows.len() - row.len());
            self.frames.pop();
        }
        self.rows.try_reserve(row.len())?;
        self.frames.push(state)?;
        self.rows.extend_from_slice(row);
        self.count += 1;
        Ok(())
    }

    /// Tells Python; whether it wants an end.
    fn tell(&mut self, row: &[f64], state: &State) -> PyResult<bool> {
        let mut wants_end = false;
        if let Some(callback) = &self.callback {
            let mut frames = Frames::new(Keep::All);
            frames.push(state).map_err(|_| PyMemoryError::new_err("no memory for a state"))?;
            wants_end |= Python::attach(|py| {
                let states = States::new(&self.simulation, self.model.clone_ref(py), frames);
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

impl Observer for Follower {
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
        match self.tell(row, state) {
            Ok(false) => Ok(ControlFlow::Continue(())),
            Ok(true) => Ok(ControlFlow::Break(())),
            Err(error) => {
                self.signals.raise(error);
                Ok(ControlFlow::Break(()))
            }
        }
    }

    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}
