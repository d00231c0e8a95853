//! Gas between shells, rubber and wrinkled membranes.

mod balloons;
mod gases;
mod rubber;
mod sphere;
mod wrinkles;

use crate::Problem;

/// Problems of gases and membranes.
pub(super) const FAMILIES: [&[Problem]; 4] =
    [gases::PROBLEMS, rubber::PROBLEMS, balloons::PROBLEMS, wrinkles::PROBLEMS];
