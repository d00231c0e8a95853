//! Thin plates and shells.

mod bending;
mod curved;
mod models;
mod motions;
mod plates;

use crate::Problem;

/// Problems of plates and shells.
pub(super) const FAMILIES: [&[Problem]; 4] =
    [bending::PROBLEMS, curved::PROBLEMS, plates::PROBLEMS, motions::PROBLEMS];
