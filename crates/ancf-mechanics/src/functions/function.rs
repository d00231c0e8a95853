use std::f64::consts::TAU;
use std::sync::Arc;

use super::expression::Expression;
use super::external_function::ExternalFunction;
use super::function_value::FunctionValue;
use super::input_signal::InputSignal;
use super::time_table::TimeTable;

/// Dimensionless function f of time t.
///
/// At jumps and kinks, value and rates are right-sided limits. For the left-sided limits, an integrator ends its step
/// at [`f64::next_down`] of a break.
#[derive(Clone, Debug)]
pub enum Function {
    /// Constant.
    Constant(f64),
    /// Piecewise linear between points.
    Table(TimeTable),
    /// Ramp: 0, then linear from `start` to `end`, then 1.
    Ramp {
        /// Time at the start of the ramp.
        start: f64,
        /// Time at the end of the ramp, after the start.
        end: f64,
    },
    /// Step from 0 to 1 at a time, and optionally back to 0.
    Step {
        /// Time of the step to 1.
        at: f64,
        /// Time of the step back to 0, if any.
        until: Option<f64>,
    },
    /// sin(2π f t + φ).
    Sine {
        /// Frequency f, cycles per time.
        frequency: f64,
        /// Phase φ in radians.
        phase: f64,
    },
    /// Formula.
    Expression {
        /// Formula in t.
        formula: Arc<Expression>,
        /// Value of t in the formula at time 1.
        unit: f64,
    },
    /// User-defined function.
    External {
        /// Function.
        function: ExternalFunction,
        /// Argument t of the function at time 1.
        unit: f64,
    },
    /// Input that a program sets between steps.
    Input(InputSignal),
    /// Integral of another function from 0; unit of time.
    Integral(Arc<Integral>),
}

impl Function {
    /// Constant function 1.
    pub const ONE: Self = Self::Constant(1.0);

    /// Returns the integral from 0 in closed form, or `None` for formulas and user-defined functions.
    pub fn integral(self) -> Option<Self> {
        Some(Self::Integral(Arc::new(Integral::new(self)?)))
    }

    /// Returns true if the function is constant.
    pub const fn is_constant(&self) -> bool {
        matches!(self, Self::Constant(_))
    }

    /// Returns the value.
    pub fn value(&self, t: f64) -> f64 {
        self.at(t).value
    }

    /// Returns value and rates.
    pub fn at(&self, t: f64) -> FunctionValue {
        match self {
            Self::Constant(value) => FunctionValue { value: *value, ..FunctionValue::default() },
            Self::Table(table) => table.at(t),
            Self::Ramp { start, end } => ramp(t, *start, *end),
            Self::Step { at, until } => {
                let on = t >= *at && until.is_none_or(|until| t < until);
                FunctionValue { value: f64::from(u8::from(on)), ..FunctionValue::default() }
            }
            Self::Sine { frequency, phase } => {
                let omega = TAU * frequency;
                let (sin, cos) = (omega * t + phase).sin_cos();
                FunctionValue { value: sin, rate: omega * cos, acceleration: -omega * omega * sin }
            }
            Self::Input(input) => input.at(t),
            Self::Integral(integral) => integral.at(t),
            Self::Expression { formula, unit } => formula.at(t * unit).with_scaled_rates(*unit),
            Self::External { function, unit } => function.at(t * unit).with_scaled_rates(*unit),
        }
    }

    /// Returns the times at which the value or its rate jumps. Jumps of formulas and user-defined functions are
    /// unknown, those of inputs depend on the program.
    pub fn breaks(&self) -> Vec<f64> {
        match self {
            Self::Constant(_)
            | Self::Sine { .. }
            | Self::Expression { .. }
            | Self::External { .. }
            | Self::Input(_) => Vec::new(),
            Self::Table(table) => table.breaks(),
            Self::Integral(integral) => integral.breaks(),
            Self::Ramp { start, end } => vec![*start, *end],
            Self::Step { at, until } => [Some(*at), *until].into_iter().flatten().collect(),
        }
    }
}

fn ramp(t: f64, start: f64, end: f64) -> FunctionValue {
    let slope = 1.0 / (end - start);
    if t < start {
        FunctionValue::default()
    } else if t < end {
        FunctionValue { value: (t - start) * slope, rate: slope, acceleration: 0.0 }
    } else {
        FunctionValue { value: 1.0, ..FunctionValue::default() }
    }
}

/// Integral of a function from 0 to t, in closed form.
#[derive(Clone, Debug)]
pub struct Integral {
    of: Function,
    /// Points (t, f) of a table with the integral from the first point to each of them.
    sums: Vec<[f64; 3]>,
    /// Integral from the origin of the closed form to 0.
    origin: f64,
}

impl Integral {
    /// Creates the integral of a function, or returns `None` for formulas and user-defined functions.
    pub fn new(of: Function) -> Option<Self> {
        let sums = match &of {
            Function::Expression { .. } | Function::External { .. } | Function::Integral(_) => return None,
            Function::Table(table) => sums(table.points()),
            _ => Vec::new(),
        };
        let mut integral = Self { of, sums, origin: 0.0 };
        integral.origin = integral.primitive(0.0);
        Some(integral)
    }

    /// Returns the integral, the function and its rate.
    pub(crate) fn at(&self, t: f64) -> FunctionValue {
        let FunctionValue { value, rate, .. } = self.of.at(t);
        FunctionValue { value: self.primitive(t) - self.origin, rate: value, acceleration: rate }
    }

    /// Returns the function.
    pub(crate) fn integrand(&self) -> &Function {
        &self.of
    }

    /// Returns the times of jumps and kinks of the function.
    pub(crate) fn breaks(&self) -> Vec<f64> {
        self.of.breaks()
    }

    fn primitive(&self, t: f64) -> f64 {
        match &self.of {
            Function::Constant(value) => value * t,
            Function::Table(_) => self.area(t),
            Function::Ramp { start, end } => {
                // `clamp` requires an ordered interval, but ramps are created before they are checked.
                let on = (t.max(*start).min(*end) - start).powi(2) / (2.0 * (end - start));
                on + (t - end).max(0.0)
            }
            Function::Step { at, until } => (until.map_or(t, |until| t.min(until)) - at).max(0.0),
            Function::Sine { frequency, phase } => {
                let half = 0.5 * TAU * frequency * t;
                // (cos φ − cos(ωt + φ))/ω without cancellation.
                let part = if half == 0.0 { 1.0 } else { half.sin() / half };
                t * part * (half + phase).sin()
            }
            Function::Input(input) => input.transition().integral(t),
            Function::Expression { .. } | Function::External { .. } | Function::Integral(_) => 0.0,
        }
    }

    /// Returns the integral of the table from its first point.
    fn area(&self, t: f64) -> f64 {
        let next = self.sums.partition_point(|[time, ..]| *time <= t);
        match (next.checked_sub(1).map(|last| self.sums[last]), self.sums.first()) {
            (Some([from, _, sum]), _) => sum + 0.5 * (t - from) * (self.held(next - 1) + self.of.value(t)),
            (None, Some([from, value, _])) => (t - from) * value,
            (None, None) => 0.0,
        }
    }

    fn held(&self, point: usize) -> f64 {
        self.sums[point][1]
    }
}

fn sums(points: &[[f64; 2]]) -> Vec<[f64; 3]> {
    let (mut sum, mut before): (f64, Option<[f64; 2]>) = (0.0, None);
    let next = |&[t, f]: &[f64; 2]| {
        if let Some([t0, f0]) = before.replace([t, f]) {
            sum += 0.5 * (t - t0) * (f + f0);
        }
        [t, f, sum]
    };
    points.iter().map(next).collect()
}
