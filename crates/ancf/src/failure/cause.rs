//! What has to do with a failure besides the iteration that failed: functions of the user, joints, stability.

use ancf_solver::equations::State;
use ancf_solver::newton::{SolveError, SolveFailure};

use super::stability::{instability, is_held};
use crate::assembly::{Assembly, Redundant};

/// Nearly dependent equations are looked for with these tolerances, one after the other.
const NEARLY: [f64; 4] = [1e-8, 1e-6, 1e-4, 1e-3];

/// Why an iteration failed.
#[derive(Debug)]
pub(crate) struct Blame {
    pub(crate) reason: String,
    pub(crate) at: Place,
    pub(crate) advice: &'static str,
}

/// Where.
#[derive(Debug)]
pub(crate) enum Place {
    /// In words.
    Words(String),
    /// By an equation.
    Equation(usize),
}

const OF_FUNCTIONS: &str = "a function that is a number at all times of the analysis: `if(...)` or `max(...)` keep \
                            formulas from poles, from roots and logarithms of negative numbers; or a shorter duration";
const OF_CONTRADICTIONS: &str = "joints and drives that can hold together all the time: look at the motions that they \
                                 prescribe at this time, or leave one of them out";
const OF_DEPENDENCES: &str = "a mechanism that does not come to this configuration (a singular position or a dead \
                              point), or one joint less there; `ancf check` tells what joints tie";
const OF_BUCKLING: &str = "an analysis of kind \"buckling\" for the critical load, one of kind \"path\" for what is beyond \
                           it, or in dynamics shorter or adaptive steps and damping of the material; a small imperfection \
                           or side load decides which way it goes";

/// What is to blame for an iteration that failed on its way from a state, at a load factor.
pub(crate) fn blame(assembly: &Assembly, from: &State, load: f64, error: &SolveError) -> Option<Blame> {
    if matches!(error.failure, SolveFailure::Interrupted | SolveFailure::Memory) {
        return None;
    }
    let there = State { t: error.t, load, ..from.clone() };
    function(assembly, &there)
        .or_else(|| joints(assembly, from, &there, error))
        .or_else(|| buckling(assembly, from, error))
}

/// A function of the user that is no number.
fn function(assembly: &Assembly, there: &State) -> Option<Blame> {
    let found = assembly.no_number(there)?;
    let reason = format!("the {} of `{}` became {}", found.what, found.path, found.value);
    Some(Blame { reason, at: Place::Words(format!("`{}`", found.path)), advice: OF_FUNCTIONS })
}

/// Joints that contradict each other or tie the same.
fn joints(assembly: &Assembly, from: &State, there: &State, error: &SolveError) -> Option<Blame> {
    let blame = |reason: &str, equations: &[Redundant], advice| {
        Some(Blame { reason: reason.into(), at: Place::Words(words(equations)), advice })
    };
    let wrong = assembly.contradicting(there);
    let wrong = if wrong.is_empty() { assembly.parting(there) } else { wrong };
    if !wrong.is_empty() {
        return blame("joints contradict each other", &wrong, OF_CONTRADICTIONS);
    }
    // Without pivoting, what is singular but for rounding may be seen in the iteration only.
    let nearly = if error.failure == SolveFailure::Singular { &NEARLY[..] } else { &NEARLY[..2] };
    let new = |tolerance| {
        let found = assembly.redundant_in(from, tolerance);
        let before = assembly.redundant_in(&assembly.rest(), tolerance);
        found.into_iter().filter(|one| !before.contains(one)).collect::<Vec<_>>()
    };
    let found = nearly.iter().copied().map(new).find(|found| !found.is_empty())?;
    blame("in this configuration joints tie the same", &found, OF_DEPENDENCES)
}

/// A last state that is unstable.
fn buckling(assembly: &Assembly, from: &State, error: &SolveError) -> Option<Blame> {
    if error.failure == SolveFailure::Inverted || !is_held(assembly) {
        return None;
    }
    let found = instability(assembly, from)?;
    let directions = found.directions();
    let reason = format!("the last shape is unstable in {directions}, it buckles or snaps through");
    Some(Blame { reason, at: Place::Equation(found.at), advice: OF_BUCKLING })
}

fn words(equations: &[Redundant]) -> String {
    equations.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
}
