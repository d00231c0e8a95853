//! The problems, one file each.

mod compound_pendulum;
mod elastica;
mod flying_spaghetti;
mod frequencies;
mod instants;
mod integrators;
mod motion;
mod right_angle_frame;
mod spin_up;
mod spinning_rod;

use crate::Problem;

/// All problems, in the order of the report.
pub const ALL: &[Problem] = &[
    elastica::PROBLEM,
    frequencies::PROBLEM,
    compound_pendulum::PROBLEM,
    spin_up::PROBLEM,
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
