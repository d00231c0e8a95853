//! Rows of numbers, and products of small matrices of them, in SIMD vectors along the rows.

use nalgebra::Vector3;
use pulp::Simd;

use super::lane::{Lane, VectorLanes};

/// Length of a row.
pub(crate) const NUMBERS: usize = 16;

/// Sixteen numbers, such as one for each nodal vector or integration point of an element, aligned to the cache lines.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub(crate) struct Row(pub(crate) [f64; NUMBERS]);

impl Row {
    pub(crate) const ZERO: Self = Self([0.0; NUMBERS]);

    /// Returns the v-th SIMD vector of the row.
    #[inline(always)]
    pub(crate) fn load<S: Simd>(&self, v: usize) -> S::f64s {
        S::as_simd_f64s(&self.0).0[v]
    }

    /// Returns the v-th SIMD vector of the row as a lane.
    #[inline(always)]
    pub(crate) fn lane<S: Simd>(&self, simd: S, v: usize) -> Lane<S> {
        Lane::new(simd, self.load::<S>(v))
    }

    #[inline(always)]
    pub(crate) fn store<S: Simd>(&mut self, v: usize, x: S::f64s) {
        S::as_mut_simd_f64s(&mut self.0).0[v] = x;
    }
}

/// Sixteen vectors in space: one row for each component.
pub(crate) type VectorRows = [Row; 3];

/// Returns vector k of sixteen.
pub(crate) fn of_lane(rows: &VectorRows, k: usize) -> Vector3<f64> {
    rows.each_ref().map(|row| row.0[k]).into()
}

/// Returns the v-th lanes of sixteen vectors.
#[inline(always)]
pub(crate) fn load<S: Simd>(simd: S, rows: &VectorRows, v: usize) -> VectorLanes<S> {
    [rows[0].lane(simd, v), rows[1].lane(simd, v), rows[2].lane(simd, v)]
}

#[inline(always)]
pub(crate) fn store<S: Simd>(rows: &mut VectorRows, v: usize, lanes: VectorLanes<S>) {
    for i in 0..3 {
        rows[i].store::<S>(v, lanes[i].register());
    }
}

/// Adds Σ_t left\[t\]ᵀ right\[t\] over `count` pairs of rows.
#[inline(always)]
pub(crate) fn add_products<'a, S: Simd>(
    simd: S,
    count: usize,
    left: impl Fn(usize) -> &'a Row,
    right: impl Fn(usize) -> &'a Row,
    sum: &mut [Row; NUMBERS],
) {
    /// Rows and SIMD vectors of a tile, whose sums are in registers.
    const TILE: [usize; 2] = [4, 2];
    for v in (0..NUMBERS / S::F64_LANES).step_by(TILE[1]) {
        for a in (0..NUMBERS).step_by(TILE[0]) {
            let mut tile = [[simd.splat_f64s(0.0); TILE[1]]; TILE[0]];
            for t in 0..count {
                let (left, right) = (&left(t).0[a..a + TILE[0]], right(t));
                let right = [right.load::<S>(v), right.load::<S>(v + 1)];
                for (tile, left) in tile.iter_mut().zip(left) {
                    let left = simd.splat_f64s(*left);
                    for k in 0..TILE[1] {
                        tile[k] = simd.mul_add_e_f64s(left, right[k], tile[k]);
                    }
                }
            }
            for (row, tile) in sum[a..a + TILE[0]].iter_mut().zip(tile) {
                for k in 0..TILE[1] {
                    row.store::<S>(v + k, simd.add_f64s(row.load::<S>(v + k), tile[k]));
                }
            }
        }
    }
}

/// Adds Σ_t f_t rows\[t\] over `count` rows, for each of three factors per row.
#[inline(always)]
pub(crate) fn add_sums<'a, S: Simd>(
    simd: S,
    count: usize,
    of: impl Fn(usize) -> ([f64; 3], &'a Row),
    sums: &mut VectorRows,
) {
    if NUMBERS / S::F64_LANES < 4 {
        add_wide_sums::<S, 2>(simd, count, of, sums);
    } else {
        add_wide_sums::<S, 4>(simd, count, of, sums);
    }
}

#[inline(always)]
fn add_wide_sums<'a, S: Simd, const WIDTH: usize>(
    simd: S,
    count: usize,
    of: impl Fn(usize) -> ([f64; 3], &'a Row),
    sums: &mut VectorRows,
) {
    for first in (0..NUMBERS / S::F64_LANES).step_by(WIDTH) {
        let mut tile = [[simd.splat_f64s(0.0); WIDTH]; 3];
        for t in 0..count {
            let (factors, row) = of(t);
            for (tile, factor) in tile.iter_mut().zip(factors) {
                let factor = simd.splat_f64s(factor);
                for k in 0..WIDTH {
                    tile[k] = simd.mul_add_e_f64s(factor, row.load::<S>(first + k), tile[k]);
                }
            }
        }
        for (sum, tile) in sums.iter_mut().zip(tile) {
            for k in 0..WIDTH {
                sum.store::<S>(first + k, simd.add_f64s(sum.load::<S>(first + k), tile[k]));
            }
        }
    }
}

/// Computes Σ_k f_k rows\[k\].
#[inline(always)]
pub(crate) fn combined<S: Simd, const N: usize>(simd: S, factors: &[f64; N], rows: &[&Row; N]) -> Row {
    let mut sum = Row::ZERO;
    for v in 0..NUMBERS / S::F64_LANES {
        let mut value = simd.splat_f64s(0.0);
        for (factor, row) in factors.iter().zip(rows) {
            value = simd.mul_add_e_f64s(simd.splat_f64s(*factor), row.load::<S>(v), value);
        }
        sum.store::<S>(v, value);
    }
    sum
}
