use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Scaled;

/// State of first order of a force law, such as the integral of a controller or the output of a filter.
///
/// Formulas of the law contain its value under its name. It is a number in the units of the formulas.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct LawStateEquation {
    /// Name in the formulas of the law, and of the column of its value.
    #[schemars(length(min = 1))]
    pub name: String,
    /// Formula of its rate dz/dt, in x, v, t, inputs and the states of the law, such as `(x - z)/0.02`.
    #[schemars(length(min = 1))]
    pub rate: String,
    /// Value at the start.
    #[serde(default)]
    #[unit(number)]
    pub start: f64,
    /// Typical magnitude of the value, which determines the accuracy of its iterations; 1 by default.
    #[serde(default = "LawStateEquation::size")]
    #[unit(number)]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub size: f64,
}

impl LawStateEquation {
    const fn size() -> f64 {
        1.0
    }

    /// State with a rate, zero at the start.
    pub fn new(name: impl Into<String>, rate: impl Into<String>) -> Self {
        Self { name: name.into(), rate: rate.into(), start: 0.0, size: Self::size() }
    }
}
