use std::ops::ControlFlow;

use ancf_solver::equations::State;
use ancf_solver::newton::SolveError;

use super::run::Reason;
use super::summary::Outcome;
use crate::assembly::Assembly;
use crate::failure::{self, Blame, Place};
use crate::model::Model;
use crate::units::Scales;

/// The outcome of a run, in words and in the user's units.
pub(crate) fn outcome(
    ended: Result<ControlFlow<()>, Reason>,
    model: &Model,
    assembly: &Assembly,
    scales: Scales,
) -> Outcome {
    let failed = |time, reason, at, advice| Outcome::Failed { time, reason, at, advice };
    match ended {
        Ok(ControlFlow::Continue(())) => Outcome::Finished,
        Ok(ControlFlow::Break(())) => Outcome::Stopped,
        Err(reason) if reason.is_interruption() => Outcome::Stopped,
        Err(Reason::Motion(error, blame)) => {
            let told = format!("{error}{}", halved(model, &error));
            let Told { reason, at, advice } = Told::of(&error, told, blame, model, assembly, scales);
            failed(error.t * scales.time, reason, at, advice)
        }
        Err(Reason::Equilibrium(error, blame)) => {
            let Told { reason, at, advice } =
                Told::of(&error.cause, error.to_string(), blame, model, assembly, scales);
            failed(error.load, reason, at, advice)
        }
        Err(Reason::Eigen(error)) => {
            failed(0.0, error.to_string(), "the whole system".into(), failure::after_search(error).into())
        }
        Err(Reason::Mechanism(motions)) => {
            let reason = "there is no equilibrium to find: a motion is held by nothing".to_owned();
            failed(0.0, reason, motions, failure::OF_MECHANISMS.into())
        }
    }
}

/// A failed iteration in words.
struct Told {
    reason: String,
    at: String,
    advice: String,
}

impl Told {
    /// By what the iteration says and what else is to blame.
    fn of(
        error: &SolveError,
        said: String,
        blame: Option<Blame>,
        model: &Model,
        assembly: &Assembly,
        scales: Scales,
    ) -> Self {
        let Some(Blame { reason, at, advice }) = blame else {
            let at = assembly.place_of(error, scales.length);
            return Self { reason: said, at, advice: failure::after(error.failure, &model.analysis) };
        };
        let at = match at {
            Place::Words(words) => words,
            Place::Equation(equation) => assembly.name_in(equation, scales.length),
        };
        Self { reason: format!("{reason}: {said}"), at, advice: advice.into() }
    }
}

/// How far a step of fixed size was halved before it was given up.
fn halved(model: &Model, error: &SolveError) -> String {
    let Some(settings) = model.analysis.dynamics() else { return String::new() };
    let halves = settings.step.fixed().is_some() && error.iterations > 0 && settings.max_halvings > 0;
    if halves { format!(", with the step halved {} times", settings.max_halvings) } else { String::new() }
}

/// The motions that nothing holds in a state, if there are any.
pub(crate) fn mechanism(assembly: &Assembly, s: &State, scales: Scales) -> Option<String> {
    let motions: Vec<String> =
        assembly.free_motions(s).into_iter().map(|motion| motion.scaled(scales.length).to_string()).collect();
    (!motions.is_empty()).then(|| motions.join("; "))
}
