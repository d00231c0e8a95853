use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Scaled;

/// Input of a model: a number that a program sets between time steps.
///
/// It multiplies a load or a drive as any function of time, so it is a pure number. With `force = [1, 0, 0]`, the value is the force
/// in the unit of force of the model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Input {
    /// Name by which functions of time and programs refer to the input.
    #[schemars(length(min = 1))]
    pub name: String,
    /// Value until a program sets another one; 0 by default. Runs use it throughout.
    #[serde(default)]
    #[unit(number)]
    pub value: f64,
}
