//! A case that was run: a row of the results.

use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

use ancf::analysis::Interrupt;
use ancf::record::Every;
use ancf::{Model, Outcome, Simulation, Summary};
use toml::Value;

use super::design::Design;
use super::objective::{Gauges, Objectives};

/// How a case ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Ending {
    /// All was computed.
    Finished,
    /// Ctrl-C came before its end.
    Stopped,
    /// The equations could not be solved.
    Failed,
    /// The values do not make a valid model.
    Invalid,
}

impl Ending {
    /// Its word in the results.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Finished => "finished",
            Self::Stopped => "stopped",
            Self::Failed => "failed",
            Self::Invalid => "invalid",
        }
    }

    /// The ending of a word.
    pub fn of(word: &str) -> Option<Self> {
        [Self::Finished, Self::Stopped, Self::Failed, Self::Invalid]
            .into_iter()
            .find(|one| one.word() == word)
    }
}

/// What came of a case.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// How it ended.
    pub ending: Ending,
    /// What went wrong.
    pub message: Option<String>,
    /// The objectives in the order of their names, if it finished.
    pub objectives: Vec<Option<f64>>,
    /// Steps, equilibria, modes or critical loads.
    pub steps: Option<u64>,
    /// Newton iterations.
    pub iterations: Option<u64>,
    /// Wall-clock time.
    pub seconds: f64,
}

impl Row {
    /// Runs a case.
    pub fn of(
        case: usize,
        design: &Design,
        base: &Value,
        objectives: &Objectives,
        interrupt: &Interrupt,
    ) -> Self {
        let clock = Instant::now();
        let row = catch_unwind(AssertUnwindSafe(|| {
            let data = design.data(base, case).map_err(|error| error.to_string());
            match data.and_then(|data| Model::from_value(&data).map_err(|errors| errors.to_string())) {
                Ok(model) => Self::run(&model, objectives, interrupt),
                Err(message) => Self::without(Ending::Invalid, message, objectives),
            }
        }));
        // One case that meets an error of the program must not cost the others.
        let row = row.unwrap_or_else(|_| {
            Self::without(Ending::Failed, "the program met an error of its own".into(), objectives)
        });
        Self { seconds: clock.elapsed().as_secs_f64(), ..row }
    }

    fn run(model: &Model, objectives: &Objectives, interrupt: &Interrupt) -> Self {
        let mut gauges = Gauges::of(objectives);
        let simulation = match Simulation::new(model) {
            Ok(simulation) => simulation.heeding(interrupt.clone()),
            Err(errors) => return Self::without(Ending::Invalid, errors.to_string(), objectives),
        };
        match simulation.run(&mut Every::new(model.output.every, &mut gauges)) {
            Ok(summary) => Self::ended(model, &summary, &gauges),
            Err(error) => Self::without(Ending::Invalid, said(&error), objectives),
        }
    }

    fn ended(model: &Model, summary: &Summary, gauges: &Gauges<'_>) -> Self {
        let (values, told) = gauges.values();
        let (ending, message) = match &summary.outcome {
            Outcome::Finished => (Ending::Finished, (!told.is_empty()).then(|| told.join("\n"))),
            Outcome::Stopped => (Ending::Stopped, None),
            Outcome::Failed { .. } => (Ending::Failed, summary.outcome.failure(&model.analysis)),
        };
        // A mean until something failed is no mean of a motion.
        let objectives =
            values.into_iter().map(|value| value.filter(|_| ending == Ending::Finished)).collect();
        let (steps, iterations) = (Some(summary.steps), Some(summary.iterations));
        Self { ending, message, objectives, steps, iterations, seconds: 0.0 }
    }

    fn without(ending: Ending, message: String, objectives: &Objectives) -> Self {
        let objectives = vec![None; objectives.len()];
        Self { ending, message: Some(message), objectives, steps: None, iterations: None, seconds: 0.0 }
    }
}

fn said(error: &io::Error) -> String {
    error.get_ref().map_or_else(|| error.to_string(), ToString::to_string)
}
