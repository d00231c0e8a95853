//! Problems with known answers: closed forms, independent solutions, published numbers.
//!
//! Each problem is a file below [`problems`], named by its source: model, reference, tolerance, plot, and a test that it holds.
//! `ancf verify` solves them on the machine of the user and writes a report.

mod problem;
pub mod problems;

pub use problem::{
    Comparison, Findings, Mark, Plot, PlotCurve, Problem, SolvedModel, VerificationError, solve,
};

/// Asserts that a problem holds, for its test.
#[cfg(test)]
fn assert_holds(problem: &Problem) {
    let findings = (problem.run)().unwrap_or_else(|error| panic!("{}: {error}", problem.name));
    assert!(!findings.plots.is_empty() && !findings.comparisons.is_empty(), "{}", problem.name);
    for comparison in &findings.comparisons {
        assert!(comparison.holds(), "{}: {comparison:?} is {:e} off", problem.name, comparison.error());
    }
}
