//! Result of a case: a row of the table.

use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

use ancf::reading::ValidModel;
use ancf::record::Every;
use ancf::solver::newton::Interrupt;
use ancf::{Model, Outcome, Simulation, Summary};

use super::base_model::BaseModel;
use super::design::CaseDesign;
use super::gauges::ObjectiveGauges;
use crate::statement::Objectives;

/// Outcome of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum CaseOutcome {
    /// The analysis was completed.
    Finished,
    /// The case was interrupted.
    Stopped,
    /// The analysis failed.
    Failed,
    /// The model with the values of the case is invalid.
    Invalid,
}

impl CaseOutcome {
    /// Returns the name in the table.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Finished => "finished",
            Self::Stopped => "stopped",
            Self::Failed => "failed",
            Self::Invalid => "invalid",
        }
    }

    /// Returns the outcome of a name in the table.
    pub fn from_word(word: &str) -> Option<Self> {
        [Self::Finished, Self::Stopped, Self::Failed, Self::Invalid]
            .into_iter()
            .find(|one| one.word() == word)
    }
}

/// First characters of a warning in a message.
const WARNING: &str = "warning: ";

/// Result of a case.
#[derive(Clone, Debug, PartialEq)]
pub struct CaseRow {
    /// Outcome.
    pub outcome: CaseOutcome,
    /// Error message, or warnings and missing objectives of a finished case.
    pub message: Option<String>,
    /// Objectives in the order of their names. `None` unless the case finished.
    pub objectives: Vec<Option<f64>>,
    /// Number of steps, equilibria, modes or critical loads.
    pub steps: Option<u64>,
    /// Number of Newton iterations.
    pub iterations: Option<u64>,
    /// Wall-clock time in seconds.
    pub seconds: f64,
}

impl CaseRow {
    /// Runs a case.
    pub fn run(
        case: usize,
        design: &CaseDesign,
        base: &BaseModel,
        objectives: &Objectives,
        interrupt: &Interrupt,
    ) -> Self {
        let clock = Instant::now();
        let row = catch_unwind(AssertUnwindSafe(|| {
            match design.data(base, case).and_then(|data| ValidModel::from_value(&data)) {
                Ok(model) => Self::simulate(&model, objectives, interrupt),
                Err(errors) => Self::without(CaseOutcome::Invalid, errors.to_string(), objectives),
            }
        }));
        // A panic in one case must not end the others.
        let row = row.unwrap_or_else(|_| {
            Self::without(CaseOutcome::Failed, "internal error of the program".into(), objectives)
        });
        Self { seconds: clock.elapsed().as_secs_f64(), ..row }
    }

    fn simulate(model: &ValidModel, objectives: &Objectives, interrupt: &Interrupt) -> Self {
        let mut gauges = ObjectiveGauges::new(objectives);
        let simulation = match Simulation::of_valid(model) {
            Ok(simulation) => simulation.with_interrupt(interrupt.clone()),
            Err(errors) => return Self::without(CaseOutcome::Invalid, errors.to_string(), objectives),
        };
        match simulation.run(&mut Every::new(model.row_interval(), &mut gauges)) {
            Ok(summary) => Self::from_summary(model, &summary, &gauges),
            Err(error) => Self::without(CaseOutcome::Invalid, message_of(&error), objectives),
        }
    }

    fn from_summary(model: &Model, summary: &Summary, gauges: &ObjectiveGauges<'_>) -> Self {
        let (values, mut messages) = gauges.values();
        messages.extend(summary.warnings.iter().map(|warning| format!("{WARNING}{warning}")));
        let (outcome, message) = match &summary.outcome {
            Outcome::Finished => (CaseOutcome::Finished, (!messages.is_empty()).then(|| messages.join("\n"))),
            Outcome::Stopped => (CaseOutcome::Stopped, None),
            Outcome::Failed { .. } => (CaseOutcome::Failed, summary.outcome.failure(&model.analysis)),
        };
        // Objectives of an incomplete motion are not comparable.
        let objectives =
            values.into_iter().map(|value| value.filter(|_| outcome == CaseOutcome::Finished)).collect();
        let (steps, iterations) = (Some(summary.steps), Some(summary.iterations));
        Self { outcome, message, objectives, steps, iterations, seconds: 0.0 }
    }

    fn without(outcome: CaseOutcome, message: String, objectives: &Objectives) -> Self {
        let objectives = vec![None; objectives.len()];
        Self { outcome, message: Some(message), objectives, steps: None, iterations: None, seconds: 0.0 }
    }
}

fn message_of(error: &io::Error) -> String {
    error.get_ref().map_or_else(|| error.to_string(), ToString::to_string)
}
