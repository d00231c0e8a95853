//! Gas between shells, rubber and wrinkled membranes.

mod gases;
mod rubber;
mod sphere;
mod wrinkles;

use crate::Problem;

/// Problems of gases and membranes.
pub(super) const FAMILIES: [&[Problem]; 3] = [gases::PROBLEMS, rubber::PROBLEMS, wrinkles::PROBLEMS];
