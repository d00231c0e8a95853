//! The problems, one file each.

mod cantilever;
mod catenary;
mod elastica;
mod gerstmayr_irschik;
mod heavy_elastica;
mod locking;
mod roll_up;
mod self_weight;
mod single_element;

use crate::Problem;

/// All problems, in the order of the report.
pub const ALL: [Problem; 8] = [
    single_element::PROBLEM,
    locking::PROBLEM,
    elastica::PROBLEM,
    heavy_elastica::PROBLEM,
    roll_up::PROBLEM,
    gerstmayr_irschik::PROBLEM,
    catenary::PROBLEM,
    self_weight::PROBLEM,
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
