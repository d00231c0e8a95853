use ancf::Model;

use crate::compare::{Case, Cause, Comparison, Finding, TimeSteps, compare, with_step};
use crate::random::Random;
use crate::run::{Run, Verdict, run};

/// Result of a check.
#[derive(Clone, Debug, PartialEq)]
pub enum Check {
    /// The law does not apply to the model.
    Inapplicable,
    /// The law holds.
    Holds,
    /// The twins deviate by a measured cause: the model does not determine the results to the tolerance.
    Explained(Cause),
    /// The law is violated.
    Violated(Finding),
}

impl Check {
    /// Result of a comparison.
    pub fn of(finding: Option<Finding>) -> Self {
        finding.map_or(Self::Holds, Self::Violated)
    }
}

/// Law that all models obey.
pub trait Law: Sync {
    /// Name in tables and files.
    fn name(&self) -> &'static str;

    /// Checks the law for a model. Random numbers choose the details of a transformation.
    fn check(&self, case: &Case, random: &mut Random) -> Check;
}

/// Checks a twin: its results, mapped back, are those of the base.
pub(super) fn check_twin(
    law: &'static str,
    case: &Case,
    twin: Option<Model>,
    back: impl Fn(&mut Run),
    relative: f64,
) -> Check {
    check_motion(law, case, twin, back, (relative, TimeSteps::Same))
}

/// Checks a twin, with its relative tolerance, whose equations of a step may differ from those of the base.
pub(super) fn check_motion(
    law: &'static str,
    case: &Case,
    twin: Option<Model>,
    back: impl Fn(&mut Run),
    (relative, steps): (f64, TimeSteps),
) -> Check {
    let Some(twin) = twin else { return Check::Inapplicable };
    if matches!(case.base.verdict, Verdict::Stopped | Verdict::Panicked(_)) {
        return Check::Inapplicable;
    }
    // Twins with other equations have other estimates of the error and other steps.
    if steps == TimeSteps::Other && case.has_controlled_steps() {
        return Check::Inapplicable;
    }
    let mapped = |model: &Model| {
        let mut run = run(model);
        back(&mut run);
        run
    };
    let refined = |part: f64| {
        let finer = (steps == TimeSteps::Other).then(|| with_step(&twin, part)).flatten();
        finer.map(|model| mapped(&model))
    };
    let other = mapped(&twin);
    // Rounding errors may decide whether a step is repeated, or takes another iteration, on which its error and the next step
    // depend. The rows then belong to other times.
    if case.has_controlled_steps() && other.verdict.is_finished() && !has_same_times(&case.base, &other) {
        return Check::Explained(Cause::Steps);
    }
    match compare(law, case, (&other, &refined), relative, steps) {
        Comparison::Equal => Check::Holds,
        Comparison::Explained(cause) => Check::Explained(cause),
        Comparison::Different(finding) => Check::Violated(finding),
    }
}

/// Relative difference of the times of rows that counts as rounding error.
const SAME_TIME: f64 = 1e-9;

/// True if the rows of two motions belong to the same times.
fn has_same_times(base: &Run, other: &Run) -> bool {
    let (Some(times), Some(others)) = (base.column("t"), other.column("t")) else { return false };
    let is_same = |(a, b): (&f64, &f64)| (a - b).abs() <= SAME_TIME * a.abs().max(b.abs());
    times.values.len() == others.values.len() && times.values.iter().zip(&others.values).all(is_same)
}

/// Relative tolerance of twins with other rounding errors.
pub(super) const EQUAL: f64 = 1e-6;
