//! Products with the stiffness of a cable element, from the strains of the columns.

use ancf_solver::equations::ProductColumn;
use nalgebra::{Matrix3, Vector3};

use super::cable_profile::CableStation;
use super::cable_step::vectors;
use crate::kinematics::BendBlocks;

/// Multiple of ε |H| |d|² that bounds the rounding errors of dᵀ H d.
const ROUNDING: f64 = 4.0;

/// Stiffness of r′ at a station with its norm.
pub(super) struct AxialProduct {
    matrix: Matrix3<f64>,
    norm: f64,
}

impl AxialProduct {
    pub(super) fn new(matrix: Matrix3<f64>) -> Self {
        Self { norm: matrix.norm(), matrix }
    }
}

/// Stiffness of r′ and r″ at a station with the norms of its blocks.
pub(super) struct BendProduct {
    blocks: BendBlocks,
    norms: [f64; 3],
}

impl BendProduct {
    pub(super) fn new(blocks: BendBlocks) -> Self {
        Self { norms: [&blocks.aa, &blocks.ba, &blocks.bb].map(Matrix3::norm), blocks }
    }
}

/// Vectors of a column, with the sizes of their rounding errors, and the sums of the forces on them.
pub(super) struct CableColumn<'a> {
    target: &'a mut ProductColumn,
    x: [Vector3<f64>; 4],
    sizes: [f64; 4],
    forces: [Vector3<f64>; 4],
    rounding: f64,
}

impl<'a> CableColumn<'a> {
    pub(super) fn new(target: &'a mut ProductColumn) -> Self {
        let x = vectors(&target.x);
        let sizes = x.map(|x| f64::EPSILON * x.norm());
        Self { target, x, sizes, forces: [Vector3::zeros(); 4], rounding: 0.0 }
    }

    /// Adds the stiffness of r′ at a station times r′ of the column.
    pub(super) fn add_axial(&mut self, station: &CableStation, h: &AxialProduct) {
        let d = station.first(&self.x);
        let (force, error) = (times(&h.matrix, &d), self.error(&station.first));
        self.forces.iter_mut().zip(station.first).for_each(|(sum, s)| *sum += force * s);
        self.rounding += bound(h.norm, [d.norm(); 2], [error; 2]);
    }

    /// Adds the stiffness of r′ and r″ at a station times those of the column.
    pub(super) fn add_bending(&mut self, station: &CableStation, h: &BendProduct) {
        let BendBlocks { aa, ba, bb } = &h.blocks;
        let [a, b] = station.both(&self.x);
        let [da, db] = [self.error(&station.first), self.error(&station.second)];
        let of_a = times(aa, &a) + times_transpose(ba, &b);
        let of_b = times(ba, &a) + times(bb, &b);
        for (i, sum) in self.forces.iter_mut().enumerate() {
            *sum += of_a * station.first[i] + of_b * station.second[i];
        }
        let ([aa, ba, bb], [size_a, size_b]) = (h.norms, [a.norm(), b.norm()]);
        self.rounding += bound(aa, [size_a; 2], [da; 2])
            + 2.0 * bound(ba, [size_a, size_b], [da, db])
            + bound(bb, [size_b; 2], [db; 2]);
    }

    /// Bounds the error of the sum of the vectors with weights.
    fn error(&self, weights: &[f64; 4]) -> f64 {
        weights.iter().zip(self.sizes).map(|(w, size)| w.abs() * size).sum()
    }

    /// Adds the sums to the column.
    pub(super) fn finish(self) {
        let rows = self.target.product.iter_mut().zip(self.forces.iter().flatten());
        rows.for_each(|(product, force)| *product += force);
        self.target.rounding += self.rounding;
    }
}

/// Bounds the rounding error of xᵀ H y for the norms of H, x and y and of the errors of x and y.
fn bound(h: f64, [x, y]: [f64; 2], [dx, dy]: [f64; 2]) -> f64 {
    h * (dx * y + x * dy + dx * dy + ROUNDING * f64::EPSILON * x * y)
}

/// Computes H x. The product of the library is a function call for each column of H.
#[inline(always)]
fn times(h: &Matrix3<f64>, x: &Vector3<f64>) -> Vector3<f64> {
    Vector3::from_fn(|i, _| h[(i, 0)] * x[0] + h[(i, 1)] * x[1] + h[(i, 2)] * x[2])
}

/// Computes Hᵀ x.
#[inline(always)]
fn times_transpose(h: &Matrix3<f64>, x: &Vector3<f64>) -> Vector3<f64> {
    Vector3::from_fn(|i, _| h[(0, i)] * x[0] + h[(1, i)] * x[1] + h[(2, i)] * x[2])
}
