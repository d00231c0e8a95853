use nalgebra::DMatrix;

use super::factorisation::Factor;
use super::scaled_lu::equilibrate;
use crate::sparse::SparseMatrix;
use crate::vectors::PseudoRandom;

/// Weight of the constraints relative to the largest entry of K. It is larger than one, since multipliers add negative
/// entries of the size of K, and not an integer, so that sums do not cancel.
const WEIGHT: f64 = 61.803_398_87;

/// Returns the number of negative eigenvalues of a matrix by its factors, or else by those of the augmented matrix; `None` if neither
/// provide it.
pub(crate) fn negative_eigenvalues(k: &SparseMatrix, factor: &Factor) -> Option<usize> {
    factor.negative_pivots().or_else(|| inertia(k))
}

/// Returns the number of negative eigenvalues of [K, Φ_qᵀ; Φ_q, 0] where K may be singular without the constraints.
///
/// The inertia is that of [K + Φ_qᵀ Γ Φ_q, Φ_qᵀ; Φ_q, 0] for any Γ: both projections onto Φ_q x = 0 are equal. With
/// Γ > 0 above the size of K the pivots of rigid bodies, which have no stiffness, are far from zero. If LDLᵀ still does not succeed,
/// the eigenvalues of small matrices are computed; `None` for larger ones, and if an eigenvalue is zero by rounding.
///
/// Source: Nocedal & Wright (2006), theorem 16.3; Hestenes (1969), the augmented Lagrangian.
pub fn inertia(k: &SparseMatrix) -> Option<usize> {
    inertia_by_factors(k).or_else(|| inertia_by_eigenvalues(k))
}

/// Largest number of unknowns for which all eigenvalues are computed.
const SMALL: usize = 600;
/// Magnitude below which an eigenvalue is zero by rounding, in a matrix whose rows have a largest entry of about 1.
const ZERO: f64 = 1e-11;

fn inertia_by_eigenvalues(k: &SparseMatrix) -> Option<usize> {
    let size = k.pattern().size();
    if size > SMALL {
        return None;
    }
    let mut entries = Vec::new();
    k.visit(|i, j, value| entries.push((i, j, value)));
    let (scales, mut dense) = (equilibrate(&entries, size), DMatrix::zeros(size, size));
    for (i, j, value) in entries {
        dense[(i, j)] = scales[i] * value * scales[j];
        dense[(j, i)] = dense[(i, j)];
    }
    let eigenvalues = dense.symmetric_eigenvalues();
    let decided = eigenvalues.iter().all(|value| value.abs() > ZERO);
    decided.then(|| eigenvalues.iter().filter(|value| **value < 0.0).count())
}

fn inertia_by_factors(k: &SparseMatrix) -> Option<usize> {
    let pattern = k.pattern();
    let mut augmented = k.clone();
    let mut rows: Vec<(usize, usize, f64)> = k.constraints().filter(|row| row.2 != 0.0).collect();
    rows.sort_unstable_by_key(|&(multiplier, coordinate, _)| (multiplier, coordinate));
    // Largest entry of K, off the diagonal too: that of rigid bodies can be rounding errors only.
    let (coordinates, mut largest) = (rows.first().map_or(pattern.size(), |row| row.0), 0.0_f64);
    k.visit(|i, j, value| {
        if pattern.unknown(i).max(pattern.unknown(j)) < coordinates {
            largest = largest.max(value.abs());
        }
    });
    let scale = WEIGHT * if largest > 0.0 { largest } else { 1.0 };
    for row in rows.chunk_by(|a, b| a.0 == b.0) {
        let square: f64 = row.iter().map(|(.., entry)| entry * entry).sum();
        for (i, &(_, a, x)) in row.iter().enumerate() {
            for &(_, b, y) in &row[..=i] {
                let slot = pattern.find_slot(a, b)?;
                augmented.values_mut()[slot] += scale / square * x * y;
            }
        }
    }
    let mut factor = Factor::new(pattern).ok()?;
    factor.factorise(&augmented).ok()?;
    // A solution verifies the accuracy of the factors.
    let mut x = PseudoRandom(11).vector(pattern.size());
    factor.solve(&augmented, &mut x).ok()?;
    factor.negative_pivots()
}
