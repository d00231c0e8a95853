//! Thin plates and shells.

mod bending;
mod contact;
mod curved;
mod large;
pub(super) mod models;
mod motions;
mod plates;
mod snap;

use crate::Problem;

/// Problems of plates and shells.
pub(super) const FAMILIES: [&[Problem]; 7] = [
    bending::PROBLEMS,
    curved::PROBLEMS,
    plates::PROBLEMS,
    motions::PROBLEMS,
    large::PROBLEMS,
    snap::PROBLEMS,
    contact::PROBLEMS,
];
