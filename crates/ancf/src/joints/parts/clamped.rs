use ancf_mechanics::kinematics::Attachment;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Scaled;

/// Which gradients a clamp ties besides the position.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(rename_all = "snake_case")]
pub enum Clamped {
    /// r_x, r_y and r_z: all twelve coordinates of the node, as Kim et al. (2017) do. Stretch and shear of the axis
    /// are then zero at the clamp, which stiffens coarse meshes: 8/9 of the exact elongation for one element.
    All,
    /// r_y and r_z only: the section is fixed and the axis is free to stretch, exact in tension. Of a cable, the direction
    /// of the tangent.
    Section,
}

impl Clamped {
    /// Constrained directions among r_x, r_y and r_z.
    pub(crate) fn of(self, axes: &[Vector3<f64>; 3]) -> &[Vector3<f64>] {
        match self {
            Self::All => axes,
            Self::Section => &axes[1..],
        }
    }
}

/// Directions of an end in the reference configuration, of an end that has three.
pub(crate) fn reference(end: &Attachment) -> [Vector3<f64>; 3] {
    end.axes().map_or([Vector3::zeros(); 3], |axes| axes.each_ref().map(|axis| axis.reference()))
}
