use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use ancf::analysis::Interrupt;
use pyo3::prelude::*;

/// What Python wants while a run goes on, and the exception that ends the run.
///
/// Signals such as Ctrl-C reach Python's handlers only when they are asked for; so they are, every now and then.
#[derive(Clone, Debug, Default)]
pub(crate) struct Signals(Arc<Mutex<State>>);

#[derive(Debug, Default)]
struct State {
    asked: Option<Instant>,
    error: Option<PyErr>,
    /// What is asked besides, in a run.
    stop: Option<Py<PyAny>>,
    stopped: bool,
}

/// Between two looks at signals.
const PATIENCE: Duration = Duration::from_millis(20);

impl Signals {
    /// Begins a run, which ends when `stop` returns true.
    pub(crate) fn begin(&self, stop: Option<Py<PyAny>>) {
        let mut state = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        *state = State { stop, ..State::default() };
    }

    /// Ends the run.
    pub(crate) fn raise(&self, error: PyErr) {
        let mut state = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        state.error.get_or_insert(error);
    }

    /// The exception that ended the run.
    pub(crate) fn take(&self) -> Option<PyErr> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).error.take()
    }

    /// Whether the run is to end.
    pub(crate) fn are_set(&self) -> bool {
        let mut state = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if state.error.is_some() || state.stopped {
            return true;
        }
        if state.asked.is_some_and(|asked| asked.elapsed() < PATIENCE) {
            return false;
        }
        state.asked = Some(Instant::now());
        // Whoever has Python's lock may want this one.
        drop(state);
        match Python::attach(|py| self.ask(py)) {
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

    fn ask(&self, py: Python<'_>) -> PyResult<bool> {
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

    /// What a simulation asks.
    pub(crate) fn interrupt(&self) -> Interrupt {
        let signals = self.clone();
        Interrupt::new(move || signals.are_set())
    }
}
