use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::scales::Scales;
use crate::units::Scaled;

/// Choice of the units in which the equations are solved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum ScaleChoice {
    /// Units of the model: the dimensional form of the equations.
    None,
    /// Units of Kim et al. (2017), for one beam under gravity: the length of the beam, the weight of one element and the time by
    /// eq. (7).
    Paper,
    /// Length and weight of the longest body.
    ///
    /// The unit of force is the weight, or E I/L² without gravity. The unit of time follows from eq. (7) of Kim et al. (2017).
    /// Units are rounded to powers of two, so that conversion is exact.
    #[default]
    Auto,
    /// Given units.
    Given {
        /// Unit of length, length.
        #[unit(length)]
        #[schemars(extend("exclusiveMinimum" = 0))]
        length: f64,
        /// Unit of force, force.
        #[unit(force)]
        #[schemars(extend("exclusiveMinimum" = 0))]
        force: f64,
        /// Unit of time, time. By default it follows from eq. (7) of Kim et al. (2017) with the ρA of the longest body.
        #[unit(time)]
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        time: Option<f64>,
    },
}

/// Units chosen for a model.
#[derive(Clone, Debug, PartialEq)]
pub struct ChosenScales {
    /// Units of the equations.
    pub scales: Scales,
    /// Reason for the choice, in words.
    pub reason: String,
}
