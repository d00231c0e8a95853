use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Scaled;

/// Motions that a support constrains.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(rename_all = "snake_case")]
pub enum SupportCondition {
    /// Displacements, and the rotation of the normal about the edge.
    Clamped,
    /// Displacements.
    Hinged,
    /// Displacements along `axes`, as at a diaphragm.
    Guided,
    /// Symmetry with respect to the plane of the edge: displacements normal to the plane and rotations about the edge are zero.
    Symmetry,
}

/// Global axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(rename_all = "snake_case")]
pub enum SupportedAxis {
    /// x-axis.
    X,
    /// y-axis.
    Y,
    /// z-axis.
    Z,
}
