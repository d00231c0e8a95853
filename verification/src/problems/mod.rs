//! Problems by subject, one file each.

mod dynamics;
mod elements;
mod models;
mod stability;
mod statics;

use crate::Problem;
use dynamics::{
    compound_pendulum, flying_spaghetti, frequencies, integrators, right_angle_frame, slider_crank, spin_up,
    spinning_rod,
};
use elements::{locking, self_weight, single_element};
use stability::{euler_column, lateral_buckling, lees_frame};
use statics::{
    bathe_bolourchi, catenary, elastica, gerstmayr_irschik, heavy_elastica, invariance, princeton, roll_up,
};

/// All problems, in the order of the report.
pub const ALL: &[Problem] = &[
    elastica::PROBLEM,
    euler_column::PROBLEM,
    princeton::PROBLEM,
    bathe_bolourchi::PROBLEM,
    lees_frame::PROBLEM,
    lateral_buckling::PROBLEM,
    invariance::PROBLEM,
    single_element::PROBLEM,
    locking::PROBLEM,
    heavy_elastica::PROBLEM,
    roll_up::PROBLEM,
    gerstmayr_irschik::PROBLEM,
    catenary::PROBLEM,
    self_weight::PROBLEM,
    frequencies::PROBLEM,
    compound_pendulum::PROBLEM,
    spin_up::PROBLEM,
    slider_crank::PROBLEM,
    flying_spaghetti::PROBLEM,
    right_angle_frame::PROBLEM,
    spinning_rod::PROBLEM,
    integrators::PROBLEM,
];
