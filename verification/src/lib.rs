//! Problems with known answers: closed forms, independent solutions, published numbers.
//!
//! Each problem is an entry of a file below [`problems`], with model, reference, tolerance and plot. A test asserts that it holds.
//! `ancf verify` solves them on the machine of the user and writes a report.

mod problem;
pub mod problems;
mod reference;
mod study;

pub use problem::{
    Comparison, Findings, Mark, Plot, PlotCurve, Problem, SolvedModel, VerificationError, solve,
};
use study::Study;

/// Asserts that a problem holds, for its test.
#[cfg(test)]
fn assert_holds(problem: &Problem) {
    let findings = (problem.run)().unwrap_or_else(|error| panic!("{}: {error}", problem.name));
    assert!(!findings.plots.is_empty() && !findings.comparisons.is_empty(), "{}", problem.name);
    for comparison in &findings.comparisons {
        assert!(comparison.holds(), "{}: {comparison:?} is {:e} off", problem.name, comparison.error());
    }
}

/// Asserts that all problems of a file hold, and reports all that do not.
#[cfg(test)]
fn assert_all_hold(problems: &[Problem]) {
    let mut reports = Vec::new();
    for problem in problems {
        let clock = std::time::Instant::now();
        let report = match (problem.run)() {
            Err(error) => vec![format!("{}: {error}", problem.name)],
            Ok(findings) if findings.plots.is_empty() || findings.comparisons.is_empty() => {
                vec![format!("{}: no comparisons or plots", problem.name)]
            }
            Ok(findings) => {
                let all = std::env::var_os("ANCF_VERIFY_ALL").is_some();
                let shown = findings.comparisons.iter().filter(|comparison| all || !comparison.holds());
                let line = |c: &Comparison| {
                    let name = problem.name;
                    let verdict = if c.holds() { "holds" } else { "FAILED" };
                    format!("{name}: {verdict} {} {} {} error {:.2e} of {:.1e}", c.what, c.ours, c.reference, c.error(), c.tolerance)
                };
                shown.map(line).collect()
            }
        };
        let seconds = clock.elapsed().as_secs_f64();
        reports.extend(report.into_iter().map(|line| format!("{line}, {seconds:.2} s")));
    }
    assert!(reports.is_empty(), "{}", reports.join("\n"));
}
