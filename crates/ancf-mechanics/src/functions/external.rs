use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

use super::instant::Instant;

/// A function of time that the program supplies.
///
/// It keeps the last time and what the program said of it, so that all terms of the equations together call the program once
/// for each time. Calls come from any thread, one at a time, for times in any order: an iteration that fails begins anew
/// at an earlier one. What it returns must depend on t alone, but for this: between steps it may become another function
/// of the times that are still to come, such as what a controller sets. It must not be computed by way of this very function. A value
/// that is no number ends the analysis as one that diverged.
///
/// Clones are the same function, and equal; functions made apart are not.
#[derive(Clone)]
pub struct External(Arc<Supplied>);

struct Supplied {
    function: Box<dyn Fn(f64) -> Instant + Send + Sync>,
    last: Mutex<Option<(f64, Instant)>>,
}

impl External {
    /// The function by which the program tells value and rates at a time. Loads use values only, currents of fluids their first
    /// rates, drives both: there the rates must be the derivatives of the value.
    pub fn new(f: impl Fn(f64) -> Instant + Send + Sync + 'static) -> Self {
        Self(Arc::new(Supplied { function: Box::new(f), last: Mutex::new(None) }))
    }

    /// Its value and rates.
    pub fn at(&self, t: f64) -> Instant {
        // What is kept is whole even if the program panicked in a call.
        let mut last = self.0.last.lock().unwrap_or_else(PoisonError::into_inner);
        match *last {
            Some((then, instant)) if then == t => instant,
            _ => {
                let instant = (self.0.function)(t);
                *last = Some((t, instant));
                instant
            }
        }
    }
}

impl PartialEq for External {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl fmt::Debug for External {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("External").finish_non_exhaustive()
    }
}
