//! Flat sheets of thin and of shear-deformable shells: laminates, fields, stiffeners, motions, rotation, flight.

mod fields;
mod flight;
mod laminates;
mod model;
mod pendulums;
mod rotation;
mod stiffeners;

use crate::Problem;

/// Problems of sheets of both kinds of shells.
pub(super) const FAMILIES: [&[Problem]; 6] = [
    laminates::PROBLEMS,
    fields::PROBLEMS,
    stiffeners::PROBLEMS,
    pendulums::PROBLEMS,
    flight::PROBLEMS,
    rotation::PROBLEMS,
];
