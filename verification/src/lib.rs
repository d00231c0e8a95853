//! Problems with known answers: closed forms, independent solutions, published numbers.
//!
//! Each problem is an entry of a file below [`problems`], with model, reference, tolerance and plot. A test asserts that it holds.
//! `ancf verify` solves them on the machine of the user and writes a report.

mod effectivity;
mod estimated;
mod problem;
pub mod problems;
mod reference;
mod refinement;

pub use effectivity::Effectivity;
use estimated::estimated;
pub use problem::{
    Comparison, Findings, Mark, Plot, PlotCurve, Problem, SolvedModel, VerificationError, solve,
};
use refinement::Refinement;

/// Asserts that a problem holds, for its test.
#[cfg(test)]
fn assert_holds(problem: &Problem) {
    let findings = (problem.run)().unwrap_or_else(|error| panic!("{}: {error}", problem.name));
    assert!(!findings.plots.is_empty() && !findings.comparisons.is_empty(), "{}", problem.name);
    for comparison in &findings.comparisons {
        assert!(comparison.holds(), "{}: {comparison:?} is {:e} off", problem.name, comparison.error());
    }
    for effectivity in &findings.effectivities {
        assert!(effectivity.holds(), "{}: {effectivity:?}: ratio {}", problem.name, effectivity.ratio());
    }
}

/// Asserts that all problems of a file hold, and reports all that do not.
#[cfg(test)]
fn assert_all_hold(problems: &[Problem]) {
    let reports: Vec<String> = problems.iter().flat_map(reports).collect();
    assert!(reports.is_empty(), "{}", reports.join("\n"));
}

/// Returns the reasons why a problem does not hold.
#[cfg(test)]
fn reports(problem: &Problem) -> Vec<String> {
    let name = problem.name;
    match (problem.run)() {
        Err(error) => vec![format!("{name}: {error}")],
        Ok(findings) if findings.plots.is_empty() || findings.comparisons.is_empty() => {
            vec![format!("{name}: no comparisons or plots")]
        }
        Ok(findings) => {
            let broken = findings.comparisons.iter().filter(|comparison| !comparison.holds());
            let broken = broken.map(|broken| format!("{name}: {broken:?} is {:e} off", broken.error()));
            let wrong = findings.effectivities.iter().filter(|effectivity| !effectivity.holds());
            broken.chain(wrong.map(|wrong| format!("{name}: {wrong:?}: ratio {}", wrong.ratio()))).collect()
        }
    }
}
