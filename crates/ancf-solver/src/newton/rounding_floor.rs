use crate::equations::Weights;
use crate::sparse::SparseMatrix;

/// Raises the bounds of the constraints to what a solution of the linear equations can reach.
///
/// A factorisation solves K z = b with an error of each row i of some ε maxₖ |zₖ|/dₖ / dᵢ, where D K D has entries of size
/// one: the error of a small component is relative to the largest. Where a joint to the ground makes Φ a coordinate
/// itself, that is far above the rounding error ε|q| of its evaluation. Coordinates have this noise from all
/// steps so far, hence
///
/// |Φᵢ| ≲ ε maxⱼ(|Φ_q,ij| dⱼ) · maxₖ (|qₖ| + w_q |zₖ|)/dₖ,  dₖ = Kₖₖ^−½.
///
/// The increments of multipliers are among the zₖ, with 1/dₖ = maxⱼ(|Φ_q,kj| dⱼ): where nothing moves they are the largest.
///
/// Free of units, of slope lengths and of the frame.
///
/// Source: Rigal & Gaches (1967) for the error of a linear solution.
pub(crate) fn raise_to_achievable(k: &SparseMatrix, q: &[f64], z: &[f64], w: Weights, floor: &mut [f64]) {
    let root = |i: usize| k.diagonal_of(i).abs().sqrt();
    let mut moved = (0..q.len()).map(|i| (q[i].abs() + w.q * z[i].abs()) * root(i)).fold(0.0, f64::max);
    for (multiplier, coordinate, entry) in k.constraints() {
        let root = root(coordinate);
        if root > 0.0 {
            moved = moved.max(w.q * (z[multiplier] * entry).abs() / root);
        }
    }
    let (before, rows) = floor.split_at_mut(q.len());
    let first = before.len();
    for (multiplier, coordinate, entry) in k.constraints() {
        let root = root(coordinate);
        if root > 0.0 {
            let row = &mut rows[multiplier - first];
            *row = row.max(f64::EPSILON * moved * entry.abs() / root);
        }
    }
}
