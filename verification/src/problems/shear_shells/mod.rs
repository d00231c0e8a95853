//! Shear-deformable shells on meshes of quadrilaterals.

mod large;
mod linear;
mod mesh;
mod plates;

use crate::Problem;

/// Problems of shear-deformable shells.
pub(super) const FAMILIES: [&[Problem]; 3] = [linear::PROBLEMS, plates::PROBLEMS, large::PROBLEMS];
