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
}

/// Between two looks at signals.
const PATIENCE: Duration = Duration::from_millis(20);

impl Signals {
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
    fn are_set(&self) -> bool {
        let mut state = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if state.error.is_some() {
            return true;
        }
        if state.asked.is_some_and(|asked| asked.elapsed() < PATIENCE) {
            return false;
        }
        state.asked = Some(Instant::now());
        drop(state);
        match Python::attach(|py| py.check_signals()) {
            Ok(()) => false,
            Err(error) => {
                self.raise(error);
                true
            }
        }
    }

    /// What a simulation asks.
    pub(crate) fn interrupt(&self) -> Interrupt {
        let signals = self.clone();
        Interrupt::new(move || signals.are_set())
    }
}
