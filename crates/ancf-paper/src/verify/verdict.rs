use ancf_verification::{Comparison, Findings, Problem};

/// What came out of a problem.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// The problem.
    pub problem: Problem,
    /// Ours beside the references, or why there is nothing.
    pub findings: Result<Findings, String>,
    /// Time it took.
    pub seconds: f64,
}

impl Verdict {
    /// Whether everything that was compared holds, and anything was.
    pub fn holds(&self) -> bool {
        self.worst().is_some() && self.comparisons().iter().all(Comparison::holds)
    }

    /// What was compared.
    pub fn comparisons(&self) -> &[Comparison] {
        self.findings.as_ref().map_or(&[], |findings| &findings.comparisons)
    }

    /// The comparison whose error is the largest part of its tolerance.
    pub fn worst(&self) -> Option<&Comparison> {
        self.comparisons().iter().max_by(|a, b| share(a).total_cmp(&share(b)))
    }

    /// Why there is nothing to compare, if so.
    pub fn reason(&self) -> Option<&str> {
        match &self.findings {
            Err(reason) => Some(reason),
            Ok(findings) if findings.comparisons.is_empty() => Some("it compares nothing"),
            Ok(_) => None,
        }
    }

    /// In a word.
    pub fn word(&self) -> &'static str {
        if self.holds() { "holds" } else { "FAILED" }
    }

    /// A line for the terminal, with so much room for the name.
    pub fn line(&self, width: usize) -> String {
        let Self { problem, seconds, .. } = self;
        let found = match self.worst() {
            Some(worst) => format!("error {:>7.1e} of {:>7.1e}", worst.error(), worst.tolerance),
            None => "could not be solved     ".to_owned(),
        };
        let line = format!("{:width$}  {:6}  {found}  {seconds:>7.2} s", problem.name, self.word());
        match (self.reason(), self.worst().filter(|worst| !worst.holds())) {
            (Some(reason), _) => format!("{line}  {reason}"),
            (_, Some(worst)) => format!("{line}  {}", worst.what),
            _ => line,
        }
    }
}

/// The error as a part of the tolerance; what is not a number exceeds all.
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
    use ancf_verification::Error;

    use super::*;

    fn verdict(findings: Result<Findings, String>) -> Verdict {
        let run = || Err(Error::Missing("all".into()));
        let problem = Problem { name: "p", title: "", source: "", sketch: "", goal: "", run };
        Verdict { problem, findings, seconds: 0.5 }
    }

    fn compared(errors: &[f64]) -> Verdict {
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
            (compared(&[]), "it compares nothing"),
        ] {
            assert!(!nothing.holds());
            assert!(nothing.line(1).ends_with(reason), "{}", nothing.line(1));
        }
    }
}
