use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use serde::{Deserialize, Serialize};

use super::function_value::FunctionValue;

/// Input that a program sets between time steps: constant, with linear transitions.
///
/// f(t) = f₀ + (f₁ − f₀)(t − t₀)/(t₁ − t₀) for t₀ ≤ t < t₁, and f₁ afterwards. The integral from 0 is continued over all
/// settings, so an input may drive a rate. Times before t₀ are not evaluated.
///
/// Clones are the same input. It must not be set during a step.
#[derive(Clone)]
pub struct InputSignal(Arc<[AtomicU64; 5]>);

/// Last transition of an input.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct InputTransition {
    /// Start t₀ and end t₁ of the transition, time.
    pub times: [f64; 2],
    /// Values f₀ at its start and f₁ from its end on.
    pub values: [f64; 2],
    /// Integral of the input from 0 to t₀.
    pub integral: f64,
}

impl InputTransition {
    /// Creates a constant from t = 0 on.
    pub const fn constant(value: f64) -> Self {
        Self { times: [0.0; 2], values: [value; 2], integral: 0.0 }
    }

    /// Creates the transition to a value at the time `now`, linear over a duration or at once.
    #[must_use]
    pub fn towards(&self, value: f64, now: f64, duration: f64) -> Self {
        let before = if now < self.times[1] { self.at(now).value } else { self.values[1] };
        Self { times: [now, now + duration], values: [before, value], integral: self.integral(now) }
    }

    /// Continues the transition of the time `now` at another time, with the present value. The integral is that up to this time.
    #[must_use]
    pub fn moved(&self, now: f64, to: f64) -> Self {
        let rest = (self.times[1] - now).max(0.0);
        let value = if rest > 0.0 { self.at(now).value } else { self.values[1] };
        Self { times: [to, to + rest], values: [value, self.values[1]], integral: self.integral(to) }
    }

    /// Returns true if all numbers are finite and the times are in order.
    pub fn is_valid(&self) -> bool {
        let numbers = self.times.iter().chain(&self.values).chain([&self.integral]);
        numbers.into_iter().all(|x| x.is_finite()) && self.times[0] <= self.times[1]
    }

    /// Returns value and rates.
    pub fn at(&self, t: f64) -> FunctionValue {
        let ([from, to], [start, end]) = (self.times, self.values);
        if t >= to {
            return FunctionValue { value: end, ..FunctionValue::default() };
        }
        if t <= from {
            let rate = if to > from { (end - start) / (to - from) } else { 0.0 };
            return FunctionValue { value: start, rate, acceleration: 0.0 };
        }
        let rate = (end - start) / (to - from);
        FunctionValue { value: start + rate * (t - from), rate, acceleration: 0.0 }
    }

    /// Returns the integral from 0 to t.
    pub fn integral(&self, t: f64) -> f64 {
        let ([from, to], [start, end]) = (self.times, self.values);
        let within = t.min(to);
        let here = if within < to { self.at(within).value } else { end };
        let mean = if to > from { 0.5 * (start + here) } else { 0.0 };
        self.integral + mean * (within - from) + end * (t - within)
    }
}

impl InputSignal {
    /// Creates an input with a constant value.
    pub fn new(value: f64) -> Self {
        let signal = Self(Arc::default());
        signal.set(InputTransition::constant(value));
        signal
    }

    /// Returns the last transition.
    pub fn transition(&self) -> InputTransition {
        let [from, to, start, end, integral] =
            std::array::from_fn(|i| f64::from_bits(self.0[i].load(Ordering::Relaxed)));
        InputTransition { times: [from, to], values: [start, end], integral }
    }

    /// Sets the transition, between steps.
    pub fn set(&self, transition: InputTransition) {
        let InputTransition { times: [from, to], values: [start, end], integral } = transition;
        for (own, number) in self.0.iter().zip([from, to, start, end, integral]) {
            own.store(number.to_bits(), Ordering::Relaxed);
        }
    }

    /// Returns value and rates.
    pub fn at(&self, t: f64) -> FunctionValue {
        self.transition().at(t)
    }
}

/// Inputs with equal values are equal.
impl PartialEq for InputSignal {
    fn eq(&self, other: &Self) -> bool {
        self.transition() == other.transition()
    }
}

impl fmt::Debug for InputSignal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("InputSignal").field(&self.transition()).finish()
    }
}
