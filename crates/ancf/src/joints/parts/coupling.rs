use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Coupled joints, such as gears, racks, belts and screws.
///
/// The sum of the angles and displacements of the joints, multiplied by their factors, is zero.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Coupling {
    /// Name in messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// Joints and their factors, at most 63.
    #[schemars(length(min = 2))]
    pub joints: Vec<Coupled>,
}

/// Joint of a coupling.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Coupled {
    /// Name of the joint.
    pub joint: String,
    /// Factor, not zero: a number for an angle, 1/length for a displacement.
    pub factor: f64,
    /// Coupled coordinate of the joint; by default the angle, if the joint has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub of: Option<JointCoordinate>,
}

/// Free coordinate of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum JointCoordinate {
    /// Angle about the axis.
    Angle,
    /// Displacement along the axis.
    Displacement,
}
