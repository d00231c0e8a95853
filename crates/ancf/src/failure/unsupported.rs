//! Unsupported motions, for which a model has no equilibrium.

use ancf_solver::equations::State;

use super::run_failure::RunFailure;
use crate::assembly::Assembly;
use crate::diagnosis::MAX_LISTED;
use crate::units::Scales;

/// Returns an error if a motion is unsupported in a state.
pub(crate) fn require_support(assembly: &Assembly, s: &State, scales: Scales) -> Result<(), RunFailure> {
    let motions = unsupported_motions(assembly, s, scales);
    motions.map_or(Ok(()), |motions| Err(RunFailure::Mechanism(motions)))
}

/// Description of the unsupported motions in a state; `None` if there are none, or if the model is too large to determine them in
/// seconds. The factorisation of the stiffness then decides.
fn unsupported_motions(assembly: &Assembly, s: &State, scales: Scales) -> Option<String> {
    let motions = assembly.free_motions(s).unwrap_or_default();
    let count = motions.len();
    let mut texts: Vec<String> =
        motions.into_iter().take(MAX_LISTED).map(|motion| motion.scaled(scales.length).to_string()).collect();
    if count > MAX_LISTED {
        texts.push(format!("and {} more", count - MAX_LISTED));
    }
    (count > 0).then(|| texts.join("; "))
}
