//! Shear-deformable shells on meshes of quadrilaterals and triangles.

mod chrono;
mod discs;
mod large;
mod linear;
pub(super) mod mesh;
mod pinched;
mod plates;
mod strips;
mod triangles;

use crate::Problem;

/// Problems of shear-deformable shells.
pub(super) const FAMILIES: [&[Problem]; 8] = [
    linear::PROBLEMS,
    discs::PROBLEMS,
    strips::PROBLEMS,
    plates::PROBLEMS,
    large::PROBLEMS,
    pinched::PROBLEMS,
    triangles::PROBLEMS,
    chrono::PROBLEMS,
];
