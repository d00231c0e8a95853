use nalgebra::{Cholesky, SMatrix};
use pulp::Simd;

use super::hermite::VECTORS;
use super::tables::MEMBRANE;
use crate::lanes::Row;

/// Membrane stiffness D of an element over its membrane strains, as the factor R of D = Rᵀ R.
///
/// With the factor, Bᵀ D B is the square of R B, which takes half of the operations.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct MembraneStiffness {
    /// Rows of the upper triangle.
    factor: [f64; start(MEMBRANE)],
}

/// Index of the first entry of a row of the upper triangle.
const fn start(row: usize) -> usize {
    row * MEMBRANE - row * (row + 1) / 2 + row
}

impl MembraneStiffness {
    /// Factorises a stiffness matrix. The entries are NaN if the matrix is not positive definite.
    pub(crate) fn new(stiffness: &SMatrix<f64, MEMBRANE, MEMBRANE>) -> Self {
        let factor = Cholesky::new(*stiffness).map(|factor| factor.unpack());
        let entry = |t: usize, s: usize| factor.as_ref().map_or(f64::NAN, |factor| factor[(s, t)]);
        let mut rows = [0.0; start(MEMBRANE)];
        for t in 0..MEMBRANE {
            (t..MEMBRANE).for_each(|s| rows[start(t) + s - t] = entry(t, s));
        }
        Self { factor: rows }
    }

    /// Returns the diagonal and the following entries of a row of R.
    #[inline(always)]
    fn row(&self, t: usize) -> &[f64] {
        &self.factor[start(t)..start(t) + MEMBRANE - t]
    }

    /// Computes D ε.
    pub(crate) fn stress(&self, strains: &[f64; MEMBRANE]) -> [f64; MEMBRANE] {
        let mut stress = [0.0; MEMBRANE];
        for t in 0..MEMBRANE {
            let row = self.row(t);
            let part: f64 = row.iter().zip(&strains[t..]).map(|(r, strain)| r * strain).sum();
            stress[t..].iter_mut().zip(row).for_each(|(stress, r)| *stress += r * part);
        }
        stress
    }

    /// Replaces the rows B by R B.
    #[inline(always)]
    pub(crate) fn multiply<S: Simd>(&self, simd: S, rows: &mut [[Row; 3]; MEMBRANE]) {
        if VECTORS / S::F64_LANES < 4 {
            self.multiply_wide::<S, 2>(simd, rows);
        } else {
            self.multiply_wide::<S, 4>(simd, rows);
        }
    }

    #[inline(always)]
    fn multiply_wide<S: Simd, const WIDTH: usize>(&self, simd: S, rows: &mut [[Row; 3]; MEMBRANE]) {
        for t in 0..MEMBRANE {
            // Rows before t are complete, and rows from t on are still those of B.
            let factors = self.row(t);
            for first in (0..VECTORS / S::F64_LANES).step_by(WIDTH) {
                let mut sums = [[simd.splat_f64s(0.0); WIDTH]; 3];
                for (factor, row) in factors.iter().zip(&rows[t..]) {
                    if *factor == 0.0 {
                        continue;
                    }
                    let factor = simd.splat_f64s(*factor);
                    for i in 0..3 {
                        for k in 0..WIDTH {
                            sums[i][k] = simd.mul_add_e_f64s(factor, row[i].load::<S>(first + k), sums[i][k]);
                        }
                    }
                }
                for (row, sums) in rows[t].iter_mut().zip(sums) {
                    for k in 0..WIDTH {
                        row.store::<S>(first + k, sums[k]);
                    }
                }
            }
        }
    }
}
