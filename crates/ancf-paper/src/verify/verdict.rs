//! Outcome of a verification problem.

use ancf_verification::{Comparison, Effectivity, Findings, Problem};

/// Outcome of a verification problem.
#[derive(Clone, Debug)]
pub struct ProblemVerdict {
    /// Problem.
    pub problem: Problem,
    /// Comparisons with references, or the reason why there are none.
    pub findings: Result<Findings, String>,
    /// Wall-clock time, s.
    pub seconds: f64,
}

impl ProblemVerdict {
    /// True if there are comparisons and all of them hold, with the estimates of the errors.
    pub fn holds(&self) -> bool {
        let is_compared = self.worst().is_some() && self.comparisons().iter().all(Comparison::holds);
        is_compared && self.effectivities().iter().all(Effectivity::holds)
    }

    /// Returns the estimated errors of the mesh with the true ones.
    pub fn effectivities(&self) -> &[Effectivity] {
        self.findings.as_ref().map_or(&[], |findings| &findings.effectivities)
    }

    /// Returns the smallest and the largest ratio of estimated and true errors, as text; empty without estimates.
    pub fn effectivity_range(&self) -> String {
        let ratios = || self.effectivities().iter().map(Effectivity::ratio);
        let (low, high) =
            (ratios().fold(f64::INFINITY, f64::min), ratios().fold(f64::NEG_INFINITY, f64::max));
        match self.effectivities().len() {
            0 => String::new(),
            1 => format!("{low:.2}"),
            _ => format!("{low:.2}..{high:.2}"),
        }
    }

    /// Returns the comparisons.
    pub fn comparisons(&self) -> &[Comparison] {
        self.findings.as_ref().map_or(&[], |findings| &findings.comparisons)
    }

    /// Returns the comparison with the largest ratio of error to tolerance.
    pub fn worst(&self) -> Option<&Comparison> {
        self.comparisons().iter().max_by(|a, b| share(a).total_cmp(&share(b)))
    }

    /// Returns the reason why there are no comparisons, if any.
    pub fn reason(&self) -> Option<&str> {
        match &self.findings {
            Err(reason) => Some(reason),
            Ok(findings) if findings.comparisons.is_empty() => Some("the problem has no comparisons"),
            Ok(_) => None,
        }
    }

    /// Returns the verdict in a word.
    pub fn word(&self) -> &'static str {
        if self.holds() { "passed" } else { "FAILED" }
    }

    /// Returns a line for the terminal. The name has `width` characters.
    pub fn line(&self, width: usize) -> String {
        let Self { problem, seconds, .. } = self;
        let found = match self.worst() {
            Some(worst) => format!("error {:>7.1e} of {:>7.1e}", worst.error(), worst.tolerance),
            None => "could not be solved     ".to_owned(),
        };
        let line = format!("{:width$}  {:6}  {found}  {seconds:>7.2} s", problem.name, self.word());
        let effectivity = self.effectivities().iter().find(|effectivity| !effectivity.holds());
        match (self.reason(), self.worst().filter(|worst| !worst.holds()), effectivity) {
            (Some(reason), ..) => format!("{line}  {reason}"),
            (_, Some(worst), _) => format!("{line}  {}", worst.what),
            (.., Some(wrong)) => {
                format!("{line}  estimated error of {}: {:.2} of it", wrong.what, wrong.ratio())
            }
            _ if self.effectivities().is_empty() => line,
            _ => format!("{line}  estimate/error {}", self.effectivity_range()),
        }
    }
}

/// Returns the ratio of error to tolerance. NaN exceeds every number.
fn share(comparison: &Comparison) -> f64 {
    let share = comparison.error() / comparison.tolerance;
    match comparison.error() {
        0.0 => 0.0,
        _ if share.is_nan() => f64::INFINITY,
        _ => share,
    }
}

#[cfg(test)]
mod tests {
    use ancf_verification::VerificationError;

    use super::*;

    fn verdict(findings: Result<Findings, String>) -> ProblemVerdict {
        let run = || Err(VerificationError::Missing("all".into()));
        let problem = Problem { name: "p", title: "", source: "", sketch: "", goal: "", run };
        ProblemVerdict { problem, findings, seconds: 0.5 }
    }

    fn compared(errors: &[f64]) -> ProblemVerdict {
        let mut findings = Findings::default();
        for (k, error) in errors.iter().enumerate() {
            findings.compare(format!("number {k}"), 1.0 + error, 1.0, 1.0, 0.1);
        }
        verdict(Ok(findings))
    }

    #[test]
    fn the_worst_decides() {
        let good = compared(&[0.01, 0.05, 0.0]);
        assert!(good.holds() && good.worst().unwrap().what == "number 1");
        let bad = compared(&[0.01, f64::NAN, 0.5]);
        assert!(!bad.holds() && bad.worst().unwrap().what == "number 1");
        assert!(bad.line(3).starts_with("p    FAILED  error     NaN of  1.0e-1"), "{}", bad.line(3));
        assert!(bad.line(3).ends_with("number 1"));
    }

    #[test]
    fn nothing_compared_is_no_success() {
        for (nothing, reason) in [
            (verdict(Err("no equilibrium".into())), "no equilibrium"),
            (compared(&[]), "the problem has no comparisons"),
        ] {
            assert!(!nothing.holds());
            assert!(nothing.line(1).ends_with(reason), "{}", nothing.line(1));
        }
    }
}
