use ancf::Model;
use ancf::model::{NewtonMethod, Step};
use ancf::units::Dimension;

use super::case::{Case, NUDGE, nudged};
use super::columns::{NEIGHBOUR, compare_within};
use super::finding::Finding;
use crate::run::{Record, Run, Verdict, run};

/// Result of a comparison.
#[derive(Clone, Debug, PartialEq)]
pub enum Comparison {
    /// No deviation above the tolerance.
    Equal,
    /// A deviation that the model itself has, with its measured cause.
    Explained(Cause),
    /// Another deviation.
    Different(Finding),
}

/// Measured cause of a deviation of twins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// Neighbours of the model, which differ in the eleventh digit, deviate as much: the motion amplifies rounding errors.
    Rounding,
    /// The steps of the twins differ, and the model with half the step or with other divided steps deviates as much: the error
    /// of the steps.
    Steps,
}

impl Cause {
    /// Words for reports.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Rounding => "rounding errors",
            Self::Steps => "the errors of large steps",
        }
    }
}

/// Part of the warning that the integration has made energy.
const UNRESOLVED: &str = "the steps do not resolve the motion";

/// Part of the warning that steps were halved since they made energy.
const HALVED: &str = "steps made energy";

/// Part of the warning that accelerations alternate.
const ALTERNATING: &str = "the accelerations alternate";

/// Number of iterations of an increment above which the iteration may end in any one of several equilibria.
const MANY_ITERATIONS: f64 = 40.0;

/// Relative changes of the properties of further neighbours, in multiples of [`NUDGE`].
const NUDGES: [f64; 6] = [-1.0, 0.5, -0.3, 2.0, -3.0, 0.1];

/// Differences of the results that are not those of rounding errors but of the discretisation in time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TimeSteps {
    /// The twins have the same equations in each step, unless steps are divided.
    Same,
    /// The twins have the same motion, but other errors of the steps.
    Other,
}

/// Compares a twin, mapped back to the frame and units of the base, with the base, and looks for the cause of a deviation.
///
/// Causes are sought in dynamics only: fixed steps may be too large for stiff parts, and the iterations of large steps fail
/// or converge by their rounding errors. The division of a step, or the part of the motion that the steps do not resolve,
/// then differs between twins. `refined` runs a twin of other equations with a part of the step.
pub fn compare(
    law: &'static str,
    case: &Case,
    (twin, refined): (&Run, &dyn Fn(f64) -> Option<Run>),
    relative: f64,
    steps: TimeSteps,
) -> Comparison {
    let compare = |more: &dyn Fn(&Record, usize) -> f64| compare_within(law, case, twin, relative, more);
    let Some(finding) = compare(&|_, _| 0.0) else { return Comparison::Equal };
    if finding.quantity == "verdict" && is_numerical(&case.base) && is_numerical(twin) && case.is_dynamic() {
        // One of the twins failed in steps that the other one completed.
        let other = with_step(&case.model, 0.5).map(|model| run(&model));
        let is_resolved = other.is_some_and(|half| half.verdict.is_finished() && !half.is_divided);
        return if is_resolved {
            Comparison::Different(finding)
        } else {
            Comparison::Explained(Cause::Steps)
        };
    }
    // The program itself reports it.
    let is_warned_of =
        |part: &str| [&case.base, twin].iter().any(|run| run.warnings.iter().any(|text| text.contains(part)));
    let dimension = case.base.column(&finding.quantity).and_then(|column| column.dimension);
    let is_position = matches!(dimension, Some(Dimension::LENGTH | Dimension::NUMBER));
    let is_long = |run: &&Run| {
        run.column("iterations").is_some_and(|column| column.values.iter().any(|x| *x > MANY_ITERATIONS))
    };
    let is_distant = !case.is_dynamic() && [&case.base, twin].iter().any(is_long);
    if is_distant || (is_warned_of(ALTERNATING) && !is_position) {
        return Comparison::Explained(Cause::Steps);
    }
    if !case.is_dynamic() || !case.base.verdict.is_finished() || !twin.verdict.is_finished() {
        return Comparison::Different(finding);
    }
    let neighbours: Vec<Run> =
        NUDGES.iter().map(|factor| run(&nudged(&case.model, factor * NUDGE))).collect();
    let spread = |column: &Record, row: usize| {
        let one = |run: &Run| case.spread(column, run.column(&column.name), row);
        NEIGHBOUR * neighbours.iter().map(one).fold(0.0, f64::max)
    };
    let Some(finding) = compare(&spread) else { return Comparison::Explained(Cause::Rounding) };
    let is_divided = case.base.is_divided || twin.is_divided;
    if !is_divided && steps == TimeSteps::Same {
        return Comparison::Different(finding);
    }
    // For the twin whose steps are divided otherwise.
    if is_warned_of(UNRESOLVED) || is_warned_of(HALVED) {
        return Comparison::Explained(Cause::Steps);
    }
    if case.has_controlled_steps() {
        return Comparison::Different(finding);
    }
    let others = if is_divided { divided(&case.model) } else { Vec::new() };
    let of_base =
        StepErrors::new(&case.base, others, |part| with_step(&case.model, part).map(|model| run(&model)));
    let of_twin = StepErrors::new(twin, Vec::new(), refined);
    let error = |column: &Record, row: usize| of_base.of(column, row) + of_twin.of(column, row);
    match compare(&|column, row| spread(column, row) + error(column, row)) {
        Some(finding) => Comparison::Different(finding),
        None => Comparison::Explained(Cause::Steps),
    }
}

/// True if a run was complete or its steps failed.
fn is_numerical(run: &Run) -> bool {
    matches!(run.verdict, Verdict::Finished | Verdict::Failed(_))
}

/// Model with a part of the step; `None` with controlled steps.
pub fn with_step(model: &Model, part: f64) -> Option<Model> {
    let mut model = model.clone();
    let dynamics = model.analysis.dynamics_mut()?;
    let Step::Fixed(step) = &mut dynamics.step else { return None };
    *step *= part;
    Some(model)
}

/// Runs of the same equations whose steps are divided elsewhere: their iterations fail after other numbers.
fn divided(model: &Model) -> Vec<Run> {
    let limits = [
        (7, NewtonMethod::Full),
        (12, NewtonMethod::Full),
        (14, NewtonMethod::Modified),
        (25, NewtonMethod::Modified),
    ];
    let with = |(limit, newton)| {
        let mut model = model.clone();
        if let Some(dynamics) = model.analysis.dynamics_mut() {
            (dynamics.max_iterations, dynamics.newton) = (limit, newton);
        }
        run(&model)
    };
    limits.map(with).into()
}

/// Errors of the steps: largest differences so far from runs with half and a quarter of the step and from runs with other divided
/// steps, for all columns of a dimension.
struct StepErrors<'a> {
    run: &'a Run,
    /// Runs with the number of their rows for each row.
    others: Vec<(usize, Run)>,
}

impl<'a> StepErrors<'a> {
    fn new(run: &'a Run, others: Vec<Run>, refined: impl Fn(f64) -> Option<Run>) -> Self {
        let finer = [2, 4].into_iter().filter_map(|ratio| Some((ratio, refined(1.0 / ratio as f64)?)));
        Self { run, others: finer.chain(others.into_iter().map(|run| (1, run))).collect() }
    }

    /// Bound of the error in a row, and of up to twice of it in a twin. Errors of accelerations alternate, so the next row counts
    /// too.
    fn of(&self, column: &Record, row: usize) -> f64 {
        let alike = self.run.columns.iter().filter(|other| other.dimension == column.dimension);
        let error = |run: &Run, ratio: usize, own: &Record| {
            let Some(other) = run.column(&own.name) else { return 0.0 };
            let pairs = own.values.iter().zip(other.values.iter().step_by(ratio)).take(row + 2);
            pairs.map(|(a, b)| (a - b).abs()).filter(|x| x.is_finite()).fold(0.0, f64::max)
        };
        let largest =
            |own: &Record| self.others.iter().map(|(ratio, run)| error(run, *ratio, own)).fold(0.0, f64::max);
        3.0 * alike.map(largest).fold(0.0, f64::max)
    }
}
