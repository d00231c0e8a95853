//! Flat sheets of thin and of shear-deformable shells: laminates, motions, rotation, flight.

mod fields;
mod flight;
mod laminates;
mod model;
mod pendulums;
mod rotation;

use crate::Problem;

/// Problems of sheets of both kinds of shells.
pub(super) const FAMILIES: [&[Problem]; 5] =
    [laminates::PROBLEMS, fields::PROBLEMS, pendulums::PROBLEMS, flight::PROBLEMS, rotation::PROBLEMS];
