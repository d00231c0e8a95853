use std::f64::consts::TAU;
use std::sync::Arc;

use super::expression::Expression;
use super::external::External;
use super::integral::Integral;
use super::table::Table;

/// A function f of time t, a pure number.
///
/// Where it jumps or kinks, value and rates are those from there on: an integrator that is to see what was before ends its
/// step at [`f64::next_down`] of a break.
#[derive(Clone, Debug)]
pub enum Function {
    /// The same at all times.
    Constant(f64),
    /// Linear between points.
    Table(Table),
    /// 0, then linear from `start` to `end`, then 1.
    Ramp {
        /// Where it leaves 0.
        start: f64,
        /// Where it reaches 1, after the start.
        end: f64,
    },
    /// 0, then 1 from a time on, and 0 again from another.
    Step {
        /// Where it becomes 1.
        at: f64,
        /// Where it becomes 0 again; never if there is no such time.
        until: Option<f64>,
    },
    /// sin(2π f t + φ).
    Sine {
        /// Frequency f, cycles per time.
        frequency: f64,
        /// Phase φ in radians.
        phase: f64,
    },
    /// A formula.
    Expression {
        /// The formula.
        formula: Arc<Expression>,
        /// The t of the formula at time 1.
        unit: f64,
    },
    /// One that the program supplies.
    External {
        /// The function.
        function: External,
        /// The t of the function at time 1.
        unit: f64,
    },
    /// The integral of another function from 0 on; time.
    Integral(Arc<Integral>),
}

/// A function at one time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Instant {
    /// f.
    pub value: f64,
    /// df/dt, 1/time.
    pub rate: f64,
    /// d²f/dt², 1/time².
    pub acceleration: f64,
}

impl Instant {
    /// The same of a function whose time passes `unit` times as fast.
    fn quickened(self, unit: f64) -> Self {
        Self { rate: self.rate * unit, acceleration: self.acceleration * unit * unit, ..self }
    }
}

impl Function {
    /// The function that is always 1.
    pub const ONE: Self = Self::Constant(1.0);

    /// Its integral from 0 on, if there is a closed form: there is, but of formulas and of what the program supplies.
    pub fn integral(self) -> Option<Self> {
        Some(Self::Integral(Arc::new(Integral::new(self)?)))
    }

    /// Whether it is the same at all times.
    pub const fn is_constant(&self) -> bool {
        matches!(self, Self::Constant(_))
    }

    /// Its value.
    pub fn value(&self, t: f64) -> f64 {
        self.at(t).value
    }

    /// Its value and rates.
    pub fn at(&self, t: f64) -> Instant {
        match self {
            Self::Constant(value) => Instant { value: *value, ..Instant::default() },
            Self::Table(table) => table.at(t),
            Self::Ramp { start, end } => ramp(t, *start, *end),
            Self::Step { at, until } => {
                let on = t >= *at && until.is_none_or(|until| t < until);
                Instant { value: f64::from(u8::from(on)), ..Instant::default() }
            }
            Self::Sine { frequency, phase } => {
                let omega = TAU * frequency;
                let (sin, cos) = (omega * t + phase).sin_cos();
                Instant { value: sin, rate: omega * cos, acceleration: -omega * omega * sin }
            }
            Self::Integral(integral) => integral.at(t),
            Self::Expression { formula, unit } => formula.at(t * unit).quickened(*unit),
            Self::External { function, unit } => function.at(t * unit).quickened(*unit),
        }
    }

    /// Times at which it or its rate jumps, as far as they are known: formulas and programs do not tell.
    pub fn breaks(&self) -> Vec<f64> {
        match self {
            Self::Constant(_) | Self::Sine { .. } | Self::Expression { .. } | Self::External { .. } => {
                Vec::new()
            }
            Self::Table(table) => table.breaks(),
            Self::Integral(integral) => integral.breaks(),
            Self::Ramp { start, end } => vec![*start, *end],
            Self::Step { at, until } => [Some(*at), *until].into_iter().flatten().collect(),
        }
    }
}

fn ramp(t: f64, start: f64, end: f64) -> Instant {
    let slope = 1.0 / (end - start);
    if t < start {
        Instant::default()
    } else if t < end {
        Instant { value: (t - start) * slope, rate: slope, acceleration: 0.0 }
    } else {
        Instant { value: 1.0, ..Instant::default() }
    }
}
