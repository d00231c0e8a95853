use std::sync::Arc;

use ancf_mechanics::functions::{Expression, ExpressionError, External, Function, Instant, Table};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A function of time by which a load or an angle is multiplied: a number, or a table that says how it varies.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum TimeFunction {
    /// The same at all times.
    Constant(f64),
    /// It varies.
    Varying(Varying),
}

impl Default for TimeFunction {
    fn default() -> Self {
        Self::Constant(1.0)
    }
}

/// How a function varies in time. All values are pure numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Varying {
    /// Linear between points, held before the first and after the last.
    Table {
        /// Times of the points, in order; two equal ones are a jump. Time.
        #[schemars(length(min = 1))]
        times: Vec<f64>,
        /// Values at these times.
        #[schemars(length(min = 1))]
        values: Vec<f64>,
    },
    /// 0 until the start, then linear up to 1 at the end, then 1.
    Ramp {
        /// Where it leaves 0, time.
        #[serde(default)]
        start: f64,
        /// Where it reaches 1, time.
        end: f64,
    },
    /// 0, then 1 from a time on.
    Step {
        /// Where it becomes 1, time.
        #[serde(default)]
        at: f64,
        /// Where it becomes 0 again, time; never by default.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        until: Option<f64>,
    },
    /// sin(2π f t + φ).
    Sine {
        /// Frequency f, cycles per time.
        #[schemars(extend("minimum" = 0))]
        frequency: f64,
        /// Phase φ in radians.
        #[serde(default)]
        phase: f64,
    },
    /// A formula in t.
    Expression {
        /// The formula in t, the time, such as `if(t < 2, t^2/4, 1)`.
        #[schemars(length(min = 1))]
        text: String,
        /// The t of the formula when one unit of time has passed; 1 by default.
        #[serde(default = "one")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        unit: f64,
    },
    /// A function that the program supplies under this name; the command line has none.
    External {
        /// The name under which the program supplies it.
        #[schemars(length(min = 1))]
        name: String,
        /// The t of the function when one unit of time has passed; 1 by default.
        #[serde(default = "one")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        unit: f64,
        /// The function, once it is supplied ([`Model::supply`]).
        #[serde(skip)]
        #[schemars(skip)]
        supplied: Option<External>,
    },
}

fn one() -> f64 {
    1.0
}

impl TimeFunction {
    /// One that the program supplies under a name.
    pub fn external(name: &str) -> Self {
        Self::Varying(Varying::External { name: name.into(), unit: 1.0, supplied: None })
    }

    /// Whether its value jumps, as far as is known: formulas and programs do not tell.
    pub(crate) fn jumps(&self) -> bool {
        match self {
            Self::Varying(Varying::Step { .. }) => true,
            Self::Varying(Varying::Table { times, .. }) => times.windows(2).any(|pair| pair[0] == pair[1]),
            _ => false,
        }
    }

    /// The function to be evaluated: 0 in the place of one that is not yet supplied.
    ///
    /// # Errors
    /// If a formula is not understood.
    pub fn compile(&self) -> Result<Function, ExpressionError> {
        Ok(match self {
            Self::Constant(value) => Function::Constant(*value),
            Self::Varying(Varying::Table { times, values }) => {
                Function::Table(Table::new(times.iter().zip(values).map(|(&t, &f)| [t, f])))
            }
            &Self::Varying(Varying::Ramp { start, end }) => Function::Ramp { start, end },
            &Self::Varying(Varying::Step { at, until }) => Function::Step { at, until },
            &Self::Varying(Varying::Sine { frequency, phase }) => Function::Sine { frequency, phase },
            Self::Varying(Varying::Expression { text, unit }) => {
                Function::Expression { formula: Arc::new(Expression::parse(text)?), unit: *unit }
            }
            Self::Varying(Varying::External { unit, supplied, .. }) => {
                let rest = || External::new(|_| Instant::default());
                Function::External { function: supplied.clone().unwrap_or_else(rest), unit: *unit }
            }
        })
    }
}

/// What functions of time are when a model is assembled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Clock {
    /// As given, for dynamics.
    Runs,
    /// 0, for the closing of gaps: drives have not begun.
    Waits,
    /// 1, for statics: loads have their full values and grow by the load factor.
    Stands,
}

impl Clock {
    /// The function to be evaluated, of a checked model.
    pub(crate) fn function(self, time: &TimeFunction) -> Function {
        match self {
            Self::Runs => time.compile().expect("the formulas of a checked model can be read"),
            Self::Waits => Function::Constant(0.0),
            Self::Stands => Function::ONE,
        }
    }
}
