use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Joints that move together: the sum of their angles and displacements, times factors, stays zero. Gears, racks, belts, screws.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Coupling {
    /// Name in messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// The joints and their factors, 63 at most.
    #[schemars(length(min = 2))]
    pub joints: Vec<Coupled>,
}

/// A joint of a coupling.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Coupled {
    /// Name of the joint.
    pub joint: String,
    /// Factor, not zero: a number for an angle, 1/length for a displacement.
    pub factor: f64,
    /// Which freedom of the joint; by default the angle, if it has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub of: Option<Freed>,
}

/// A freedom of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Freed {
    /// The angle about the axis.
    Angle,
    /// The displacement along the axis.
    Displacement,
}
