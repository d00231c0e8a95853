use ancf_mechanics::kinematics::Attachment;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::model::Place;
use crate::units::Scaled;

/// Second end of a joint.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(rename_all = "snake_case")]
pub enum End {
    /// Fixed frame: `"ground"`.
    #[default]
    Ground,
    /// Place on another body.
    #[serde(untagged)]
    Place(Place),
    /// Point of the fixed frame. In statics the load factor moves the first end to it.
    #[serde(untagged)]
    Point(Ground),
}

/// Point of the fixed frame.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Ground {
    /// Coordinates of the point, length.
    #[unit(length)]
    pub point: [f64; 3],
}

/// Gradients that a clamp constrains in addition to the position.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(rename_all = "snake_case")]
pub enum ClampedGradients {
    /// r_x, r_y and r_z: all twelve coordinates of the node, as in Kim et al. (2017). Stretch and shear of the axis are zero at
    /// the clamp, which stiffens coarse meshes: one element has 8/9 of the exact elongation.
    All,
    /// The rotation of the section: it may change its size and shape, and the axis stretches freely, exact in tension. For a
    /// cable, the direction of the tangent.
    Section,
}

impl ClampedGradients {
    /// Constrained directions among r_x, r_y and r_z.
    pub(crate) fn of(self, axes: &[Vector3<f64>; 3]) -> &[Vector3<f64>] {
        match self {
            Self::All => axes,
            Self::Section => &axes[1..],
        }
    }
}

/// Directions of an end in the reference configuration; zero for an end without directions.
pub(crate) fn reference(end: &Attachment) -> [Vector3<f64>; 3] {
    end.axes().map_or([Vector3::zeros(); 3], |axes| axes.each_ref().map(|axis| axis.reference()))
}
