//! Estimated errors of coarse meshes.

mod eigenvalues;
mod statics;

use crate::Problem;

/// Problems of all files.
pub(super) const FAMILIES: [&[Problem]; 2] = [statics::PROBLEMS, eigenvalues::PROBLEMS];
