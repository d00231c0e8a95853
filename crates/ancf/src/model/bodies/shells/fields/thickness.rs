use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Scaled;

/// Thickness of a shell: a number, or a field over the surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(untagged)]
pub enum ShellThickness {
    /// Constant thickness, length.
    Uniform(
        #[unit(length)]
        #[schemars(extend("exclusiveMinimum" = 0))]
        f64,
    ),
    /// Thickness that varies.
    Varying(ThicknessField),
}

/// Thickness as a field over a shell. All plies have the same proportion of it everywhere.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum ThicknessField {
    /// Formula in the position x, y, z in the reference state, and in u, v of a thin shell.
    Expression {
        /// Formula, such as `0.01*(2 - x)`.
        #[schemars(length(min = 1))]
        text: String,
        /// Length of the unit of x, y, z and of the value of the formula: 0.001 for millimetres in a model in metres, length; 1 by default.
        #[serde(default = "one")]
        #[unit(length)]
        #[schemars(extend("exclusiveMinimum" = 0))]
        unit: f64,
    },
    /// Values at the nodes of the mesh of a shear-deformable shell. Between them they are interpolated.
    Nodes {
        /// Thickness at each node, length.
        #[unit(length)]
        #[schemars(length(min = 3))]
        values: Vec<f64>,
    },
}

pub(super) const fn one() -> f64 {
    1.0
}

impl From<f64> for ShellThickness {
    fn from(thickness: f64) -> Self {
        Self::Uniform(thickness)
    }
}

impl ShellThickness {
    /// Constant thickness; `None` for a field.
    pub const fn uniform(&self) -> Option<f64> {
        if let Self::Uniform(thickness) = self { Some(*thickness) } else { None }
    }
}
