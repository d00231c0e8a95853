//! Thin plates and shells.

mod bending;
mod contact;
mod curved;
mod large;
pub(super) mod models;
mod motions;
mod plates;
mod snap;
mod static_plates;
mod strips;
mod tape;

use crate::Problem;

/// Problems of plates and shells.
pub(super) const FAMILIES: [&[Problem]; 10] = [
    bending::PROBLEMS,
    curved::PROBLEMS,
    plates::PROBLEMS,
    static_plates::PROBLEMS,
    strips::PROBLEMS,
    motions::PROBLEMS,
    large::PROBLEMS,
    snap::PROBLEMS,
    contact::PROBLEMS,
    tape::PROBLEMS,
];
