use std::ops::ControlFlow;

use ancf_solver::newton::{SolveError, SolveFailure};

use super::summary::Outcome;
use crate::assembly::Assembly;
use crate::errors::quoted;
use crate::estimate::HalvedModel;
use crate::failure::{self, FailureCause, FailurePlace, RunFailure};
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
    let advise = |failure| failure::advice_for_iteration(failure, &model.analysis);
    match result {
        Ok(ControlFlow::Continue(())) => Outcome::Finished,
        Ok(ControlFlow::Break(())) => Outcome::Stopped,
        Err(failure) if failure.is_interruption() => Outcome::Stopped,
        Err(RunFailure::Solve(error, cause)) => {
            let message = format!("{error}{}", halvings(model, &error));
            let FailureText { reason, at, advice } =
                FailureText::new(&error, message, cause, &advise, assembly, scales);
            failed(error.t * scales.time, reason, at, advice)
        }
        Err(RunFailure::Equilibrium(error, cause)) => {
            let FailureText { reason, at, advice } =
                FailureText::new(&error.cause, error.to_string(), cause, &advise, assembly, scales);
            failed(error.load, reason, at, advice)
        }
        Err(RunFailure::Eigen(error)) => {
            let advice = failure::advice_for_eigen(error).into();
            failed(0.0, error.to_string(), WHOLE.into(), advice)
        }
        Err(RunFailure::Mechanism(motions)) => {
            failed(0.0, MECHANISM.to_owned(), motions, failure::ADVICE_FOR_MECHANISMS.into())
        }
        Err(RunFailure::Start(failure)) => {
            let FailureText { reason, at, advice } = start_failure(*failure, assembly, scales);
            failed(0.0, reason, at, advice)
        }
        Err(RunFailure::NoState(folder)) => {
            let FailureText { reason, at, advice } = FailureText::without_state(&folder);
            failed(0.0, reason, at, advice)
        }
    }
}

/// Reason of the failure of a second solution, with elements of half the size.
pub(crate) fn finer_failure(failure: RunFailure, halved: &HalvedModel, scales: Scales) -> String {
    let reason = match outcome(Err(failure), &halved.model, &halved.assembly, scales) {
        Outcome::Failed { reason, .. } => reason,
        Outcome::Finished | Outcome::Stopped => "it was interrupted".into(),
    };
    format!("the solution with elements of half the size failed: {reason}")
}

/// Place of a failure that has no place.
const WHOLE: &str = "the whole system";
/// Reason of a failure by unsupported motions.
const MECHANISM: &str = "the model has no equilibrium: a motion is unsupported";

/// Texts of a failed search for the equilibrium at the start of a motion.
fn start_failure(failure: RunFailure, assembly: &Assembly, scales: Scales) -> FailureText {
    let advise = &failure::advice_for_start;
    let text = match failure {
        RunFailure::NoState(folder) => return FailureText::without_state(&folder),
        RunFailure::Solve(error, cause) => {
            FailureText::new(&error, error.to_string(), cause, advise, assembly, scales)
        }
        RunFailure::Equilibrium(error, cause) => {
            FailureText::new(&error.cause, error.to_string(), cause, advise, assembly, scales)
        }
        RunFailure::Mechanism(at) => {
            let (reason, advice) = (MECHANISM.into(), failure::ADVICE_FOR_MECHANISMS_AT_START.into());
            FailureText { reason, at, advice }
        }
        RunFailure::Eigen(error) => {
            let advice = failure::advice_for_eigen(error).into();
            FailureText { reason: error.to_string(), at: WHOLE.into(), advice }
        }
        RunFailure::Start(failure) => return start_failure(*failure, assembly, scales),
    };
    FailureText { reason: format!("equilibrium at the start: {}", text.reason), ..text }
}

/// Texts of a failed iteration.
struct FailureText {
    reason: String,
    at: String,
    advice: String,
}

impl FailureText {
    /// Texts of a results folder whose state the program did not supply.
    fn without_state(folder: &str) -> Self {
        Self {
            reason: format!("the state of the results folder {} was not supplied", quoted(folder)),
            at: "`initial.from`".into(),
            advice: "`ancf run`, `ancf.run` of Python, or `Simulation::run_from` of Rust, which start from given states".into(),
        }
    }

    /// Combines the message of the iteration with the cause, if a cause was found.
    fn new(
        error: &SolveError,
        message: String,
        cause: Option<FailureCause>,
        advise: &dyn Fn(SolveFailure) -> String,
        assembly: &Assembly,
        scales: Scales,
    ) -> Self {
        let Some(FailureCause { reason, at, advice }) = cause else {
            let at = assembly.place_of(error, scales.length);
            return Self { reason: message, at, advice: advise(error.failure) };
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
