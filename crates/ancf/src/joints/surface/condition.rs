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

/// Rotations of a seam.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(rename_all = "snake_case")]
pub enum SeamCondition {
    /// The angle of both surfaces along the seam is constant: smooth surfaces stay smooth, kinks keep their angle.
    #[default]
    Rigid,
    /// The surfaces rotate freely about the seam.
    Hinged,
}
