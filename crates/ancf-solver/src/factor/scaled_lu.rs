//! LU factorisation with pivoting of an equilibrated matrix.

use std::sync::Arc;

use faer::MatMut;
use faer::prelude::Solve;
use faer::sparse::linalg::solvers::{Lu, SymbolicLu};
use faer::sparse::{SparseColMat, Triplet};

use crate::sparse::{Pattern, SparseMatrix};

/// LU factors with partial pivoting of S K S, where the largest entry of each row has about size one.
///
/// Stiffnesses exceed the entries of constraints by orders of magnitude in some units, and those of rigid bodies are far smaller.
/// Without scales, pivots would be chosen by units.
///
/// Source: Ruiz (2001) for the scales; faer for LU.
pub(super) struct ScaledLu {
    factors: Lu<usize, f64>,
    /// Scales S by position.
    scales: Vec<f64>,
}

/// Number of sweeps of the equilibration. Each one halves the logarithms of the sizes of the rows.
const SWEEPS: usize = 12;

/// Diagonal of the multipliers in a scaled matrix with redundant constraints.
const REGULAR: f64 = 1e-11;

impl ScaledLu {
    /// Factorises a symmetric matrix. Returns `None` if it is singular, or too large for the memory.
    pub(super) fn new(k: &SparseMatrix, size: usize) -> Option<Self> {
        Self::with_skew(k, size, &[], 0..0)
    }

    /// Factorises the sum of a symmetric matrix and of a skew one, of which the entries below the diagonal are given by position.
    ///
    /// Redundant constraints have no unique multipliers. Their scaled matrix has −[`REGULAR`] on the diagonal of the positions
    /// `multipliers`, which changes the solution by this relative amount.
    pub(super) fn with_skew(
        k: &SparseMatrix,
        size: usize,
        skew: &[(usize, usize, f64)],
        multipliers: impl IntoIterator<Item = usize>,
    ) -> Option<Self> {
        let mut entries = Vec::new();
        k.visit(|i, j, value| {
            // Padding of the supernodes.
            if value != 0.0 {
                entries.push((i, j, value));
            }
        });
        let scales = equilibrate(&entries, size);
        let triplets: Vec<_> = entries
            .iter()
            .flat_map(|&(i, j, value)| {
                let value = scales[i] * value * scales[j];
                [Some(Triplet::new(i, j, value)), (i != j).then(|| Triplet::new(j, i, value))]
            })
            .flatten()
            .chain(skew.iter().flat_map(|&(i, j, value)| {
                let value = scales[i] * value * scales[j];
                [Triplet::new(i, j, value), Triplet::new(j, i, -value)]
            }))
            .chain(multipliers.into_iter().map(|i| Triplet::new(i, i, -REGULAR)))
            .collect();
        let full = SparseColMat::try_new_from_triplets(size, size, &triplets).ok()?;
        let symbolic = SymbolicLu::try_new(full.symbolic()).ok()?;
        let factors = Lu::try_new_with_symbolic(symbolic, full.as_ref()).ok()?;
        Some(Self { factors, scales })
    }

    /// Solves K x = b in place, by position.
    pub(super) fn solve(&self, x: &mut [f64]) {
        let scale = |x: &mut [f64]| x.iter_mut().zip(&self.scales).for_each(|(x, scale)| *x *= scale);
        scale(x);
        let size = x.len();
        self.factors.solve_in_place(MatMut::from_column_major_slice_mut(x, size, 1));
        scale(x);
    }
}

/// LU factors of a bordered matrix with a symmetric and a skew part. Constraints may be redundant.
pub(crate) struct GeneralLu {
    lu: ScaledLu,
    pattern: Arc<Pattern>,
}

impl GeneralLu {
    /// Factorises the sum of a symmetric matrix and of a skew one with the entries (i, j, value), i > j. Unknowns from `coordinates` on
    /// are multipliers. Returns `None` if the sum is singular, or too large for the memory.
    pub(crate) fn new(k: &SparseMatrix, skew: &[(usize, usize, f64)], coordinates: usize) -> Option<Self> {
        let pattern = k.pattern();
        let at = |unknown| pattern.position(unknown);
        let skew: Vec<_> = skew.iter().map(|&(i, j, value)| (at(i), at(j), value)).collect();
        let multipliers = (coordinates..pattern.size()).map(at);
        let lu = ScaledLu::with_skew(k, pattern.size(), &skew, multipliers)?;
        Some(Self { lu, pattern: pattern.clone() })
    }

    /// Solves in place, by unknown.
    pub(crate) fn solve(&self, x: &mut [f64]) {
        let mut by_position = vec![0.0; x.len()];
        x.iter().enumerate().for_each(|(unknown, x)| by_position[self.pattern.position(unknown)] = *x);
        self.lu.solve(&mut by_position);
        x.iter_mut().enumerate().for_each(|(unknown, x)| *x = by_position[self.pattern.position(unknown)]);
    }
}

/// Computes scales that give the largest entry of each row a size near one.
pub(super) fn equilibrate(entries: &[(usize, usize, f64)], size: usize) -> Vec<f64> {
    let (mut scales, mut largest) = (vec![1.0; size], vec![0.0_f64; size]);
    for _ in 0..SWEEPS {
        largest.fill(0.0);
        for &(i, j, value) in entries {
            let value = (scales[i] * value * scales[j]).abs();
            largest[i] = largest[i].max(value);
            largest[j] = largest[j].max(value);
        }
        let nonzero = scales.iter_mut().zip(&largest).filter(|(_, largest)| **largest > 0.0);
        nonzero.for_each(|(scale, largest)| *scale /= largest.sqrt());
    }
    scales
}
