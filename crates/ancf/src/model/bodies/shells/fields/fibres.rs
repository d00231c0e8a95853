use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::thickness::one;
use crate::units::Scaled;

/// Angle by which all fibres of a shell are turned about the normal: a number, or a field over the surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(untagged)]
pub enum FibreAngle {
    /// Constant angle, in radians.
    Uniform(#[unit(radian)] f64),
    /// Angle that varies.
    Varying(AngleField),
}

/// Angle of fibres as a field over a shell.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum AngleField {
    /// Formula in the position x, y, z in the reference state, and in u, v of a thin shell.
    Expression {
        /// Formula of the angle in radians, such as `0.5*pi*x`.
        #[schemars(length(min = 1))]
        text: String,
        /// Length of the unit of x, y and z of the formula, length; 1 by default.
        #[serde(default = "one")]
        #[unit(length)]
        #[schemars(extend("exclusiveMinimum" = 0))]
        unit: f64,
    },
}

/// Axis whose projection on a shell is the direction of the fibre angle zero: a vector, or a field over the surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(untagged)]
pub enum FibreAxis {
    /// Constant axis.
    Uniform(#[unit(none)] [f64; 3]),
    /// Axis that varies.
    Varying(AxisField),
}

/// Axis of fibres as a field over a shell.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum AxisField {
    /// Formulas of the components in x, y, z of the reference state, and in u, v of a thin shell.
    Expression {
        /// Formulas, such as `["-y", "x", "0"]` for circles about the z axis. The length of the axis has no meaning.
        #[unit(none)]
        #[schemars(inner(length(min = 1)))]
        text: [String; 3],
        /// Length of the unit of x, y and z of the formulas, length; 1 by default.
        #[serde(default = "one")]
        #[unit(length)]
        #[schemars(extend("exclusiveMinimum" = 0))]
        unit: f64,
    },
}

impl From<[f64; 3]> for FibreAxis {
    fn from(axis: [f64; 3]) -> Self {
        Self::Uniform(axis)
    }
}

impl FibreAxis {
    /// Constant axis; `None` for a field.
    pub const fn uniform(&self) -> Option<[f64; 3]> {
        if let Self::Uniform(axis) = self { Some(*axis) } else { None }
    }
}
