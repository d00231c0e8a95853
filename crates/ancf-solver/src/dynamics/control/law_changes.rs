use super::contact_changes::unfiltered_accelerations;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::newton::SolveError;
use crate::sparse::SparseMatrix;

/// Calls `visit` with the accelerations x by force changes of laws with kinks, such as stops and ropes, within a step.
///
/// The filter of [`ErrorEstimate`](super::error_estimate::ErrorEstimate) takes them for stiff springs, whose vibrations a step need not
/// resolve. They are unfiltered like those of [contacts](super::contact_changes::ContactChanges):
///
/// [S₀, Φ_qᵀ; Φ_q, 0] (x, ·) = (R, 0),   e = ½ h² ‖x‖,
///
/// where S₀ does not contain these laws.
pub(super) fn law_accelerations<E: EquationsOfMotion>(
    eom: &E,
    [from, to]: [&State; 2],
    w: Weights,
    matrix: &SparseMatrix,
    mut visit: impl FnMut(&[f64]),
) -> Result<(), SolveError> {
    if !eom.has_kinks() {
        return Ok(());
    }
    let Some(changes) = eom.law_changes(from, &State::middle_of_step(from, to), to) else { return Ok(()) };
    let mut matrix = matrix.clone();
    eom.tangent(to, w, &mut matrix);
    eom.add_tangents(&changes.terms, to, Weights { q: -w.q, v: -w.v, a: -w.a }, &mut matrix);
    unfiltered_accelerations(&matrix, to, changes.forces, &mut visit)
}
