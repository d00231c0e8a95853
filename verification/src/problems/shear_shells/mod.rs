//! Shear-deformable shells on meshes of quadrilaterals and triangles.

mod large;
mod linear;
pub(super) mod mesh;
mod plates;
mod triangles;

use crate::Problem;

/// Problems of shear-deformable shells.
pub(super) const FAMILIES: [&[Problem]; 4] =
    [linear::PROBLEMS, plates::PROBLEMS, large::PROBLEMS, triangles::PROBLEMS];
