use crate::equations::{State, Weights};
use crate::sparse::SparseMatrix;

/// Multiple of the rounding bound below which a residual counts as zero.
pub(super) const FLOOR: f64 = 8.0;

/// Raises the rounding bounds to the accuracy of the linear solution.
///
/// A factorisation solves K z = b with an error of about ε maxₖ |zₖ|/dₖ / dᵢ in row i, where D K D has entries of size
/// one. The error of a small component is thus relative to the largest component. If a joint to the ground makes Φ a
/// coordinate, this error far exceeds the rounding error ε|q| of its evaluation. Coordinates accumulate the error over
/// all steps:
///
/// |Φᵢ| ≲ ε maxⱼ(|Φ_q,ij| dⱼ) · maxₖ (|qₖ| + w_q |zₖ|)/dₖ,  dₖ = Kₖₖ^−½.
///
/// The zₖ include the increments of multipliers, with 1/dₖ = maxⱼ(|Φ_q,kj| dⱼ). They are the largest for a system at rest.
///
/// Forces have the error of the last increment: |rᵢ| ≲ ε/dᵢ · maxₖ |zₖ|/dₖ.
///
/// Coordinates without stiffness beyond rounding errors, such as the position of a rigid body in statics, have the error of the
/// largest displacement, and their equilibrium that of the largest constraint force. Their last increment causes errors of
/// the others: |rᵢ| ≲ ε/dᵢ² · maxₖ |zₖ|.
///
/// The bound is independent of units, slope lengths and the frame of reference.
///
/// Source: Rigal & Gaches (1967) for the error of a linear solution.
pub(crate) fn raise_to_achievable(
    k: &SparseMatrix,
    State { q, lambda, .. }: &State,
    z: &[f64],
    w: Weights,
    floor: &mut [f64],
) {
    let least = k.diagonal_rounding();
    let root = |i: usize| {
        let stiffness = k.diagonal_of(i).abs();
        if stiffness > least { stiffness.sqrt() } else { 0.0 }
    };
    let mut moved = (0..q.len()).map(|i| (q[i].abs() + w.q * z[i].abs()) * root(i)).fold(0.0, f64::max);
    let mut solved = (0..q.len()).map(|i| z[i].abs() * root(i)).fold(0.0, f64::max);
    let without = (0..q.len()).filter(|&i| root(i) == 0.0).map(|i| z[i].abs()).fold(0.0, f64::max);
    for (multiplier, coordinate, entry) in k.constraints() {
        let root = root(coordinate);
        if root > 0.0 {
            let force = (z[multiplier] * entry).abs() / root;
            (moved, solved) = (moved.max(w.q * force), solved.max(force));
        }
    }
    let displaced = q.iter().zip(z).map(|(q, z)| q.abs() + w.q * z.abs()).fold(0.0, f64::max);
    let (before, rows) = floor.split_at_mut(q.len());
    let first = before.len();
    for (i, row) in before.iter_mut().enumerate() {
        *row = row.max(f64::EPSILON * solved.max(without * root(i)) * root(i));
    }
    let force = |multiplier: usize, entry: f64| {
        (lambda[multiplier - first].abs() + z[multiplier].abs()) * entry.abs()
    };
    let largest = k.constraints().map(|(multiplier, _, entry)| force(multiplier, entry)).fold(0.0, f64::max);
    for (multiplier, coordinate, entry) in k.constraints() {
        let root = root(coordinate);
        let error = if root > 0.0 { moved / root } else { displaced };
        if root == 0.0 {
            before[coordinate] = before[coordinate].max(f64::EPSILON * largest);
        }
        let row = &mut rows[multiplier - first];
        *row = row.max(f64::EPSILON * error * entry.abs());
    }
}
