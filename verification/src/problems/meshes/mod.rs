//! Estimated errors of coarse meshes and steps.

mod eigenvalues;
mod motions;
mod statics;

use crate::Problem;

/// Problems of all files.
pub(super) const FAMILIES: [&[Problem]; 3] = [statics::PROBLEMS, eigenvalues::PROBLEMS, motions::PROBLEMS];
