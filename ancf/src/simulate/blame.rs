//! What joints have to do with a failure.

use crate::analysis::{Failure, SolveError};
use crate::model::{Assembly, Redundant};
use crate::system::State;

/// Nearly dependent equations are looked for with these tolerances, one after the other.
const NEARLY: [f64; 4] = [1e-8, 1e-6, 1e-4, 1e-3];

/// Why joints made an iteration fail, and which equations did.
#[derive(Debug)]
pub(super) struct Blame {
    pub(super) reason: &'static str,
    pub(super) at: String,
}

/// The joint equations to blame for an iteration that failed on its way from a state, at a load factor.
pub(super) fn blame(assembly: &Assembly, from: &State, load: f64, error: &SolveError) -> Option<Blame> {
    if error.failure == Failure::Interrupted {
        return None;
    }
    let there = State { t: error.t, load, ..from.clone() };
    let wrong = assembly.contradicting(&there);
    if !wrong.is_empty() {
        return Some(Blame { reason: "joints contradict each other", at: words(&wrong) });
    }
    // Without pivoting, what is singular but for rounding may be seen in the iteration only.
    let nearly = if error.failure == Failure::Singular { &NEARLY[..] } else { &NEARLY[..2] };
    let new = |tolerance| {
        let found = assembly.redundant_in(from, tolerance);
        found.into_iter().filter(|one| !assembly.redundant().contains(one)).collect::<Vec<_>>()
    };
    let found = nearly.iter().copied().map(new).find(|found| !found.is_empty())?;
    Some(Blame { reason: "in this configuration joints tie the same", at: words(&found) })
}

fn words(equations: &[Redundant]) -> String {
    equations.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
}
