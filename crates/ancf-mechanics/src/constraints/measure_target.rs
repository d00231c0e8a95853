use ancf_solver::equations::Local;

use crate::functions::{Function, FunctionValue};

/// Target of a measure, relative to its reference value: c = x + b x² with x = s α f(t).
///
/// f is a function of time and s the load factor, which differs from 1 in statics only. With b = 0 the target is an
/// angle or a displacement. With b = 1/(2 L₀) the measure is half a squared length over L₀, and the target length is L₀
/// + x.
#[derive(Clone, Debug)]
pub struct MeasureTarget {
    amount: f64,
    function: Function,
    quadratic: f64,
}

impl MeasureTarget {
    /// Target at the reference value.
    pub const NONE: Self = Self { amount: 0.0, function: Function::ONE, quadratic: 0.0 };

    /// Creates the target x = α f(t).
    pub const fn new(amount: f64, function: Function) -> Self {
        Self { amount, function, quadratic: 0.0 }
    }

    /// Creates the target length L₀ + α f(t) of a measure d·d/(2 L₀).
    pub const fn of_length(length: f64, amount: f64, function: Function) -> Self {
        Self { amount, function, quadratic: 0.5 / length }
    }

    /// Returns true if the target is the reference value in all states.
    pub(crate) fn is_none(&self) -> bool {
        self.amount == 0.0
    }

    fn scaled_amount(&self, at: &Local<'_>) -> f64 {
        at.load * self.amount * self.function.value(at.t)
    }

    /// Returns c.
    pub(crate) fn value(&self, at: &Local<'_>) -> f64 {
        let x = self.scaled_amount(at);
        x + self.quadratic * x * x
    }

    /// Returns the sum of the magnitudes in c.
    pub(crate) fn size(&self, at: &Local<'_>) -> f64 {
        let x = self.scaled_amount(at);
        x.abs() + 2.0 * self.quadratic * x * x
    }

    /// Returns ∂c/∂s with respect to the load factor.
    pub(crate) fn by_load(&self, at: &Local<'_>) -> f64 {
        let x = self.scaled_amount(at);
        self.amount * self.function.value(at.t) * (1.0 + 2.0 * self.quadratic * x)
    }

    /// Returns ċ and c̈ at full load.
    pub(crate) fn rates(&self, t: f64) -> [f64; 2] {
        let FunctionValue { value, rate, acceleration } = self.function.at(t);
        let [x, v, a] = [value, rate, acceleration].map(|f| self.amount * f);
        let slope = 1.0 + 2.0 * self.quadratic * x;
        [v * slope, a * slope + 2.0 * self.quadratic * v * v]
    }
}
