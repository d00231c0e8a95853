//! Problems by subject, one file each.

mod dynamics;
mod elements;
mod forces;
mod joints;
mod membranes;
mod meshes;
mod models;
mod rigid_bodies;
mod shear_shells;
mod sheets;
mod shells;
mod stability;
mod statics;
mod vibrations;

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

/// Problems of one file each.
const SINGLE: &[Problem] = &[
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

/// Returns all problems, in the order of the report.
pub fn all() -> impl Iterator<Item = &'static Problem> {
    let bodies = joints::FAMILIES.into_iter().chain(rigid_bodies::FAMILIES);
    let small = [statics::beams::PROBLEMS, statics::curved::PROBLEMS, stability::columns::PROBLEMS];
    let families = small.into_iter().chain(bodies).chain(forces::FAMILIES).chain(vibrations::FAMILIES);
    let families = families.chain(meshes::FAMILIES).chain(shells::FAMILIES).chain(shear_shells::FAMILIES);
    let families = families.chain(sheets::FAMILIES).chain(membranes::FAMILIES);
    SINGLE.iter().chain(families.flatten())
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    /// Names are unique, and there are at least 60 problems.
    #[test]
    fn problems_have_distinct_names() {
        let names: Vec<&str> = super::all().map(|problem| problem.name).collect();
        let distinct: HashSet<&str> = names.iter().copied().collect();
        assert_eq!(distinct.len(), names.len());
        assert!(names.len() >= 60, "{}", names.len());
    }
}
