use crate::equations::{EquationsOfMotion, State, Weights};
use crate::sparse::SparseMatrix;

/// Returns the largest |A_ii| / M_ii of a tangent A, and the largest |S_ij| / √(M_ii M_jj) of skew entries (i, j, S_ij), over the
/// coordinates with mass.
pub(super) fn largest_ratios(
    eom: &dyn EquationsOfMotion,
    matrix: &SparseMatrix,
    s: &State,
    weights: Weights,
    skew: &[(usize, usize, f64)],
) -> [f64; 2] {
    let (mut mass, mut tangent) = (matrix.clone(), matrix.clone());
    eom.tangent(s, Weights::MASS, &mut mass);
    eom.tangent(s, weights, &mut tangent);
    let ratio = |value: f64, i: usize, j: usize| {
        let mass = (mass.diagonal_of(i) * mass.diagonal_of(j)).sqrt();
        if mass > 0.0 { value.abs() / mass } else { 0.0 }
    };
    let own = (0..eom.coordinates()).map(|i| ratio(tangent.diagonal_of(i), i, i)).fold(0.0, f64::max);
    let of_skew = skew.iter().map(|&(i, j, value)| ratio(value, i, j)).fold(0.0, f64::max);
    [own, of_skew]
}
