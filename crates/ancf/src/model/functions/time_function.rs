use std::sync::Arc;

use ancf_mechanics::functions::{
    Expression, ExpressionError, ExternalFunction, Function, FunctionValue, InputSignal, TimeTable,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Scaled;

/// Function of time that multiplies a load or the motion of a drive: a constant or a varying function.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(untagged)]
pub enum TimeFunction {
    /// Constant function.
    Constant(#[unit(number)] f64),
    /// Varying function.
    Varying(Varying),
}

impl Default for TimeFunction {
    fn default() -> Self {
        Self::Constant(1.0)
    }
}

/// Variation of a function in time. All values are pure numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Varying {
    /// Linear interpolation between points, constant before the first and after the last.
    Table {
        /// Times of the points in ascending order, time. Two equal times are a jump.
        #[unit(time)]
        #[schemars(length(min = 1))]
        times: Vec<f64>,
        /// Values at these times.
        #[unit(number)]
        #[schemars(length(min = 1))]
        values: Vec<f64>,
    },
    /// Ramp: 0 until the start, linear up to 1 at the end, then 1.
    Ramp {
        /// End of the value 0, time.
        #[serde(default)]
        #[unit(time)]
        start: f64,
        /// Start of the value 1, time.
        #[unit(time)]
        end: f64,
    },
    /// Step from 0 to 1, and back to 0 if stated.
    Step {
        /// Time of the step from 0 to 1, time.
        #[serde(default)]
        #[unit(time)]
        at: f64,
        /// Time of the step back to 0, time; never by default.
        #[unit(time)]
        #[serde(default, skip_serializing_if = "Option::is_none")]
        until: Option<f64>,
    },
    /// Sine: sin(2π f t + φ).
    Sine {
        /// Frequency f, cycles/time.
        #[unit(cycle / time)]
        #[schemars(extend("minimum" = 0))]
        frequency: f64,
        /// Phase φ, in radians.
        #[serde(default)]
        #[unit(radian)]
        phase: f64,
    },
    /// Formula in t.
    Expression {
        /// Formula in the time t, such as `if(t < 2, t^2/4, 1)`.
        #[schemars(length(min = 1))]
        text: String,
        /// Increase of the t of the formula per unit of time, 1/time; 1 by default.
        #[serde(default = "one")]
        #[unit(1 / time)]
        #[schemars(extend("exclusiveMinimum" = 0))]
        unit: f64,
    },
    /// External function, which the calling program supplies by name. The command line supplies none.
    External {
        /// Name by which the program supplies the function.
        #[schemars(length(min = 1))]
        name: String,
        /// Increase of the t of the function per unit of time, 1/time; 1 by default.
        #[serde(default = "one")]
        #[unit(1 / time)]
        #[schemars(extend("exclusiveMinimum" = 0))]
        unit: f64,
        /// Supplied function ([`Model::supply`](crate::model::Model::supply)).
        #[serde(skip)]
        #[unit(none)]
        #[schemars(skip)]
        supplied: Option<ExternalFunction>,
    },
    /// Input of the model, which a program sets between time steps. Runs use its declared value.
    Input {
        /// Name of the input.
        #[schemars(length(min = 1))]
        name: String,
        /// Signal of the input of this name in an assembled model.
        #[serde(skip)]
        #[unit(none)]
        #[schemars(skip)]
        signal: Option<InputSignal>,
    },
}

fn one() -> f64 {
    1.0
}

impl TimeFunction {
    /// External function, which the calling program supplies by name.
    pub fn external(name: &str) -> Self {
        Self::Varying(Varying::External { name: name.into(), unit: 1.0, supplied: None })
    }

    /// Input of the model with a name.
    pub fn input(name: &str) -> Self {
        Self::Varying(Varying::Input { name: name.into(), signal: None })
    }

    /// Name of the input, if the function is one.
    pub(crate) fn input_name(&self) -> Option<&str> {
        match self {
            Self::Varying(Varying::Input { name, .. }) => Some(name),
            _ => None,
        }
    }

    /// True if the function has a jump. Formulas are searched up to a time. Jumps of supplied functions are not detected.
    pub(crate) fn jumps(&self, until: f64) -> bool {
        match self {
            Self::Varying(Varying::Step { .. }) => true,
            Self::Varying(Varying::Table { times, .. }) => times.windows(2).any(|pair| pair[0] == pair[1]),
            Self::Varying(Varying::Expression { .. }) => {
                self.compile().is_ok_and(|function| function.jumps(until))
            }
            _ => false,
        }
    }

    /// Compiles the function for evaluation. A function that is not yet supplied, or an input without a model, is replaced by 0.
    ///
    /// # Errors
    /// If a formula has a syntax error.
    pub fn compile(&self) -> Result<Function, ExpressionError> {
        Ok(match self {
            Self::Constant(value) => Function::Constant(*value),
            Self::Varying(Varying::Table { times, values }) => {
                Function::Table(TimeTable::new(times.iter().zip(values).map(|(&t, &f)| [t, f])))
            }
            &Self::Varying(Varying::Ramp { start, end }) => Function::Ramp { start, end },
            &Self::Varying(Varying::Step { at, until }) => Function::Step { at, until },
            &Self::Varying(Varying::Sine { frequency, phase }) => Function::Sine { frequency, phase },
            Self::Varying(Varying::Expression { text, unit }) => {
                Function::Expression { formula: Arc::new(Expression::parse(text)?), unit: *unit }
            }
            Self::Varying(Varying::External { unit, supplied, .. }) => {
                let zero = || ExternalFunction::new(|_| FunctionValue::default());
                Function::External { function: supplied.clone().unwrap_or_else(zero), unit: *unit }
            }
            Self::Varying(Varying::Input { signal, .. }) => {
                signal.clone().map_or(Function::Constant(0.0), Function::Input)
            }
        })
    }
}

/// Values of the functions of time in the assembly of a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TimeMode {
    /// As given, for dynamics.
    AsGiven,
    /// Values at t = 0, for the equilibrium from which a motion starts.
    AtStart,
    /// 0, for closing gaps before drives begin.
    Zero,
    /// 1, for statics, where the load factor varies the loads; the declared value of an input.
    One,
}

impl TimeMode {
    /// Compiles a function of time of a checked model.
    pub(crate) fn function(self, time: &TimeFunction) -> Function {
        let given = || time.compile().expect("the formulas of a checked model have no syntax errors");
        match self {
            Self::AsGiven => given(),
            Self::AtStart => Function::Constant(given().value(0.0)),
            Self::Zero => Function::Constant(0.0),
            Self::One if time.input_name().is_some() => Function::Constant(given().value(0.0)),
            Self::One => Function::ONE,
        }
    }
}
