use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::errors::short;
use crate::units::{Dimension, Scaled, Scales};

/// Condition that ends a motion before its duration: a recorded value is above or below a limit.
///
/// It is checked at the recorded times (`output.interval`, each step by default). The state in which it
/// is first met is the last one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct EndCondition {
    /// Column of the results, such as `tip.z` of a probe or `hook.fx` of a joint.
    #[schemars(length(min = 1))]
    pub value: String,
    /// Limit above which the motion ends, in the unit of the column.
    #[unit(none)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub above: Option<f64>,
    /// Limit below which the motion ends, in the unit of the column.
    #[unit(none)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub below: Option<f64>,
    /// Units of length, time and force of the model, measured in units of the limits; equal by default.
    #[serde(default = "Scales::unit_scales", skip_serializing_if = "Scales::is_unit")]
    pub units: Scales,
}

impl EndCondition {
    /// Condition that a column is above a limit.
    pub fn above(value: impl Into<String>, limit: f64) -> Self {
        Self { value: value.into(), above: Some(limit), below: None, units: Scales::UNIT }
    }

    /// Condition that a column is below a limit.
    pub fn below(value: impl Into<String>, limit: f64) -> Self {
        Self { value: value.into(), above: None, below: Some(limit), units: Scales::UNIT }
    }

    /// True if a value of the column, with its dimension and in units of the model, is beyond a limit.
    pub(crate) fn is_met(&self, value: f64, dimension: Dimension) -> bool {
        let value = value * self.units.unit(dimension);
        self.above.is_some_and(|limit| value > limit) || self.below.is_some_and(|limit| value < limit)
    }

    /// Description of the limits, such as "above 0.5".
    pub(crate) fn text(&self) -> String {
        let limits = [("above", self.above), ("below", self.below)];
        let stated = limits.into_iter().filter_map(|(word, limit)| Some(format!("{word} {}", short(limit?))));
        stated.collect::<Vec<_>>().join(" or ")
    }
}
