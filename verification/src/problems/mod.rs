//! The problems, one file each.

mod bathe_bolourchi;
mod cantilever;
mod catenary;
mod compound_pendulum;
mod elastica;
mod euler_column;
mod flying_spaghetti;
mod frequencies;
mod gerstmayr_irschik;
mod heavy_elastica;
mod instants;
mod integrators;
mod invariance;
mod lateral_buckling;
mod lees_frame;
mod locking;
mod motion;
mod princeton;
mod right_angle_frame;
mod roll_up;
mod self_weight;
mod single_element;
mod slider_crank;
mod spin_up;
mod spinning_rod;

use crate::Problem;

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

/// Asserts that a problem holds, for its test.
#[cfg(test)]
fn assert_holds(problem: &Problem) {
    let findings = (problem.run)().unwrap_or_else(|error| panic!("{}: {error}", problem.name));
    assert!(!findings.plots.is_empty() && !findings.comparisons.is_empty(), "{}", problem.name);
    for comparison in &findings.comparisons {
        assert!(comparison.holds(), "{}: {comparison:?} is {:e} off", problem.name, comparison.error());
    }
}
