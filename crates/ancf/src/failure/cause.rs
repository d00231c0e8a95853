//! Causes of a failed iteration outside the iteration itself: user functions, joints, loss of stability.

use ancf_solver::equations::State;
use ancf_solver::newton::{SolveError, SolveFailure};

use super::stability::{instability, is_supported};
use crate::assembly::{Assembly, Redundant};

/// Tolerances of the search for nearly dependent equations, in the order of use.
const RANK_TOLERANCES: [f64; 4] = [1e-8, 1e-6, 1e-4, 1e-3];

/// Cause of a failed iteration.
#[derive(Debug)]
pub(crate) struct FailureCause {
    pub(crate) reason: String,
    pub(crate) at: FailurePlace,
    pub(crate) advice: &'static str,
}

/// Place of a failure.
#[derive(Debug)]
pub(crate) enum FailurePlace {
    /// Description.
    Text(String),
    /// Number of an equation.
    Equation(usize),
}

const FOR_FUNCTIONS: &str = "a function that is finite at all times of the analysis: `if(...)` or `max(...)` avoid poles, \
                             and roots and logarithms of negative numbers; or a shorter duration";
const FOR_CONTRADICTIONS: &str = "joints and drives that are compatible at all times: check the motions that they prescribe at \
                                  this time, or leave one of them out";
const FOR_DEPENDENCES: &str = "a mechanism that does not reach this configuration (a singular position or a dead point), or \
                               fewer joints there; `ancf check` lists the constraints of the joints";
const FOR_BUCKLING: &str = "an analysis of kind \"buckling\" for the critical load, one of kind \"path\" for the post-critical \
                            range, or in dynamics shorter or adaptive steps and material damping; a small imperfection or \
                            side load determines the direction";

/// Finds the cause of an iteration that failed after the state `from`, at a load factor.
pub(crate) fn find_cause(
    assembly: &Assembly,
    from: &State,
    load: f64,
    error: &SolveError,
) -> Option<FailureCause> {
    if matches!(error.failure, SolveFailure::Interrupted | SolveFailure::Memory) {
        return None;
    }
    let there = State { t: error.t, load, ..from.clone() };
    function(assembly, &there)
        .or_else(|| joints(assembly, from, &there, error))
        .or_else(|| buckling(assembly, from, error))
}

/// A user function with a value that is not finite.
fn function(assembly: &Assembly, there: &State) -> Option<FailureCause> {
    let found = assembly.no_number(there)?;
    let reason = format!("the {} of `{}` became {}", found.what, found.path, found.value);
    Some(FailureCause { reason, at: FailurePlace::Text(format!("`{}`", found.path)), advice: FOR_FUNCTIONS })
}

/// Contradictory joints, or joints whose constraints become dependent.
fn joints(assembly: &Assembly, from: &State, there: &State, error: &SolveError) -> Option<FailureCause> {
    let cause = |reason: &str, equations: &[Redundant], advice| {
        Some(FailureCause { reason: reason.into(), at: FailurePlace::Text(list(equations)), advice })
    };
    let wrong = assembly.contradicting(there);
    let wrong = if wrong.is_empty() { assembly.parting(there) } else { wrong };
    let wrong = if wrong.is_empty() { assembly.contradicting_since_rest(there) } else { wrong };
    if !wrong.is_empty() {
        return cause("joints contradict each other", &wrong, FOR_CONTRADICTIONS);
    }
    // Without pivoting, near singularity may appear in the iteration only.
    let singular = error.failure == SolveFailure::Singular;
    let tolerances = if singular { &RANK_TOLERANCES[..] } else { &RANK_TOLERANCES[..2] };
    let new = |tolerance| {
        let found = assembly.redundant_in(from, tolerance);
        let before = assembly.redundant_in(&assembly.rest(), tolerance);
        found.into_iter().filter(|one| !before.contains(one)).collect::<Vec<_>>()
    };
    let found = tolerances.iter().copied().map(new).find(|found| !found.is_empty())?;
    cause("constraints of joints are dependent in this configuration", &found, FOR_DEPENDENCES)
}

/// Instability of the last accepted state.
fn buckling(assembly: &Assembly, from: &State, error: &SolveError) -> Option<FailureCause> {
    if matches!(error.failure, SolveFailure::Inadmissible(_)) || !is_supported(assembly) {
        return None;
    }
    let found = instability(assembly, from)?;
    let directions = found.directions();
    let reason = format!("the last state is unstable in {directions} (buckling or snap-through)");
    Some(FailureCause { reason, at: FailurePlace::Equation(found.at), advice: FOR_BUCKLING })
}

fn list(equations: &[Redundant]) -> String {
    equations.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
}
