use std::ops::ControlFlow;

use ancf_solver::equations::State;
use ancf_solver::newton::SolveError;

use super::run::RunFailure;
use super::summary::Outcome;
use crate::assembly::Assembly;
use crate::diagnosis::MAX_LISTED;
use crate::failure::{self, FailureCause, FailurePlace};
use crate::model::Model;
use crate::units::Scales;

/// Converts the result of a run into an outcome in the user's units.
pub(crate) fn outcome(
    result: Result<ControlFlow<()>, RunFailure>,
    model: &Model,
    assembly: &Assembly,
    scales: Scales,
) -> Outcome {
    let failed = |time, reason, at, advice| Outcome::Failed { time, reason, at, advice };
    match result {
        Ok(ControlFlow::Continue(())) => Outcome::Finished,
        Ok(ControlFlow::Break(())) => Outcome::Stopped,
        Err(failure) if failure.is_interruption() => Outcome::Stopped,
        Err(RunFailure::Solve(error, cause)) => {
            let message = format!("{error}{}", halvings(model, &error));
            let FailureText { reason, at, advice } =
                FailureText::new(&error, message, cause, model, assembly, scales);
            failed(error.t * scales.time, reason, at, advice)
        }
        Err(RunFailure::Equilibrium(error, cause)) => {
            let FailureText { reason, at, advice } =
                FailureText::new(&error.cause, error.to_string(), cause, model, assembly, scales);
            failed(error.load, reason, at, advice)
        }
        Err(RunFailure::Eigen(error)) => {
            let advice = failure::advice_for_eigen(error).into();
            failed(0.0, error.to_string(), "the whole system".into(), advice)
        }
        Err(RunFailure::Mechanism(motions)) => {
            let reason = "the model has no equilibrium: a motion is unsupported".to_owned();
            failed(0.0, reason, motions, failure::ADVICE_FOR_MECHANISMS.into())
        }
    }
}

/// Texts of a failed iteration.
struct FailureText {
    reason: String,
    at: String,
    advice: String,
}

impl FailureText {
    /// Combines the message of the iteration with the cause, if a cause was found.
    fn new(
        error: &SolveError,
        message: String,
        cause: Option<FailureCause>,
        model: &Model,
        assembly: &Assembly,
        scales: Scales,
    ) -> Self {
        let Some(FailureCause { reason, at, advice }) = cause else {
            let at = assembly.place_of(error, scales.length);
            let advice = failure::advice_for_iteration(error.failure, &model.analysis);
            return Self { reason: message, at, advice };
        };
        let at = match at {
            FailurePlace::Text(text) => text,
            FailurePlace::Equation(equation) => assembly.name_in(equation, scales.length),
        };
        Self { reason: format!("{reason}: {message}"), at, advice: advice.into() }
    }
}

/// Number of halvings of a failed step of fixed size, as the end of a message.
fn halvings(model: &Model, error: &SolveError) -> String {
    let Some(settings) = model.analysis.dynamics() else { return String::new() };
    let halved = settings.step.fixed().is_some() && error.iterations > 0 && settings.max_halvings > 0;
    if halved { format!(", with the step halved {} times", settings.max_halvings) } else { String::new() }
}

/// Description of the unsupported motions in a state; `None` if there are none.
pub(crate) fn unsupported_motions(assembly: &Assembly, s: &State, scales: Scales) -> Option<String> {
    let motions = assembly.free_motions(s).unwrap_or_default();
    let count = motions.len();
    let mut texts: Vec<String> =
        motions.into_iter().take(MAX_LISTED).map(|motion| motion.scaled(scales.length).to_string()).collect();
    if count > MAX_LISTED {
        texts.push(format!("and {} more", count - MAX_LISTED));
    }
    (count > 0).then(|| texts.join("; "))
}
