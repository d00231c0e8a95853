use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

use super::function_value::FunctionValue;

/// User-defined function of time.
///
/// The last time and its result are stored, so all terms together call the user function once per time. Calls come from
/// any thread, one at a time, for times in any order: failed iterations restart at an earlier time. The result must
/// depend on t alone. Between steps, however, the function may change for future times, for example by a controller. It
/// must not be evaluated recursively. A result that is not a number ends the analysis as divergence.
///
/// Clones are the same function and compare equal. Separately created functions differ.
#[derive(Clone)]
pub struct ExternalFunction(Arc<UserFunction>);

struct UserFunction {
    function: Box<dyn Fn(f64) -> FunctionValue + Send + Sync>,
    last: Mutex<Option<(f64, FunctionValue)>>,
}

impl ExternalFunction {
    /// Creates a function from a user function that returns value and rates at a time.
    ///
    /// Loads use the value, currents of fluids also the first rate, and drives both rates. There the rates must be the
    /// derivatives of the value.
    pub fn new(f: impl Fn(f64) -> FunctionValue + Send + Sync + 'static) -> Self {
        Self(Arc::new(UserFunction { function: Box::new(f), last: Mutex::new(None) }))
    }

    /// Returns value and rates.
    pub fn at(&self, t: f64) -> FunctionValue {
        // The stored result is valid even after a panic in the user function.
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

impl PartialEq for ExternalFunction {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl fmt::Debug for ExternalFunction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ExternalFunction").finish_non_exhaustive()
    }
}

type ForceLaw = dyn Fn(f64, [f64; 3], [f64; 3]) -> [f64; 3] + Send + Sync;

/// User-defined force on a point as a function of time, position and velocity: F(t, x, v).
///
/// Calls come from any thread, also concurrently, for arguments in any order. The arguments include intermediate
/// iterates and finite differences. The result must depend on the arguments alone. A component that is not a number
/// ends the analysis as divergence.
///
/// Clones are the same function and compare equal. Separately created functions differ.
///
/// Units: force, time, length, length/time; all vectors in the global frame.
#[derive(Clone)]
pub struct ForceFunction(Arc<ForceLaw>);

impl ForceFunction {
    /// Creates the force from a function of time t, position x and velocity v.
    pub fn new(f: impl Fn(f64, [f64; 3], [f64; 3]) -> [f64; 3] + Send + Sync + 'static) -> Self {
        Self(Arc::new(f))
    }

    /// Returns F(t, x, v).
    pub fn at(&self, t: f64, x: [f64; 3], v: [f64; 3]) -> [f64; 3] {
        (self.0)(t, x, v)
    }

    /// Converts the force to other units. The arguments are the new units in the present ones.
    #[must_use]
    pub fn in_units(&self, length: f64, time: f64, force: f64) -> Self {
        let own = self.clone();
        let speed = length / time;
        Self::new(move |t, x, v| {
            own.at(t * time, x.map(|x| x * length), v.map(|v| v * speed)).map(|f| f / force)
        })
    }

    /// Freezes the force at a time.
    #[must_use]
    pub fn frozen_at(&self, t: f64) -> Self {
        let own = self.clone();
        Self::new(move |_, x, v| own.at(t, x, v))
    }
}

impl PartialEq for ForceFunction {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl fmt::Debug for ForceFunction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ForceFunction").finish_non_exhaustive()
    }
}
