//! Signals and exceptions of Python that end a run.

use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use ancf::solver::newton::Interrupt;
use pyo3::prelude::*;

/// Signals of Python during a run, and the exception that ends the run.
///
/// Handlers of Python receive signals such as Ctrl-C only when the interpreter checks for them, hence regular checks.
#[derive(Clone, Debug, Default)]
pub(crate) struct Signals(Arc<Mutex<State>>);

#[derive(Debug, Default)]
struct State {
    checked: Option<Instant>,
    error: Option<PyErr>,
    /// Function of Python that ends the run by a true return value.
    stop: Option<Py<PyAny>>,
    stopped: bool,
}

/// Minimum time between two checks.
const CHECK_INTERVAL: Duration = Duration::from_millis(20);

impl Signals {
    /// Begins a run that ends when `stop` returns true.
    pub(crate) fn begin(&self, stop: Option<Py<PyAny>>) {
        let mut state = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        *state = State { stop, ..State::default() };
    }

    /// Ends the run by an exception. The first exception is kept.
    pub(crate) fn raise(&self, error: PyErr) {
        let mut state = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        state.error.get_or_insert(error);
    }

    /// Takes the exception that ended the run.
    pub(crate) fn take(&self) -> Option<PyErr> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).error.take()
    }

    /// True if the run must end.
    pub(crate) fn are_set(&self) -> bool {
        let mut state = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if state.error.is_some() || state.stopped {
            return true;
        }
        if state.checked.is_some_and(|checked| checked.elapsed() < CHECK_INTERVAL) {
            return false;
        }
        state.checked = Some(Instant::now());
        // A thread that holds the interpreter lock may wait for this one.
        drop(state);
        match Python::attach(|py| self.check(py)) {
            Ok(false) => false,
            Ok(true) => {
                self.0.lock().unwrap_or_else(PoisonError::into_inner).stopped = true;
                true
            }
            Err(error) => {
                self.raise(error);
                true
            }
        }
    }

    fn check(&self, py: Python<'_>) -> PyResult<bool> {
        py.check_signals()?;
        let stop = self
            .0
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .stop
            .as_ref()
            .map(|stop| stop.clone_ref(py));
        stop.map_or(Ok(false), |stop| stop.call0(py)?.is_truthy(py))
    }

    /// Returns the interrupt of a simulation.
    pub(crate) fn interrupt(&self) -> Interrupt {
        let signals = self.clone();
        Interrupt::new(move || signals.are_set())
    }
}
