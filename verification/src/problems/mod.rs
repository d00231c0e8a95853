//! The problems, one file each.

mod bathe_bolourchi;
mod elastica;
mod euler_column;
mod invariance;
mod lateral_buckling;
mod lees_frame;
mod princeton;

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
