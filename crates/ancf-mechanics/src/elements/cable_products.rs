//! Products with the stiffness of a cable element, from the strains of the columns.

use ancf_solver::equations::ProductColumn;
use nalgebra::{Matrix3, Vector3};

use super::cable_profile::CableStation;
use super::cable_step::vectors;
use crate::kinematics::BendBlocks;

/// Multiple of ε |H| |d|² that bounds the rounding errors of dᵀ H d.
const ROUNDING: f64 = 4.0;

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
    pub(super) fn add_axial(&mut self, station: &CableStation, h: &Matrix3<f64>) {
        let (d, [du, _]) = (station.first(&self.x), self.errors(station));
        let force = h * d;
        self.forces.iter_mut().zip(station.first).for_each(|(sum, s)| *sum += force * s);
        self.rounding += bound(h.norm(), [d.norm(); 2], [du; 2]);
    }

    /// Adds the stiffness of r′ and r″ at a station times those of the column.
    pub(super) fn add_bending(&mut self, station: &CableStation, h: &BendBlocks) {
        let BendBlocks { aa, ba, bb } = h;
        let ([a, b], [da, db]) = (station.both(&self.x), self.errors(station));
        let (of_a, of_b) = (aa * a + ba.tr_mul(&b), ba * a + bb * b);
        for (i, sum) in self.forces.iter_mut().enumerate() {
            *sum += of_a * station.first[i] + of_b * station.second[i];
        }
        let [size_a, size_b] = [a.norm(), b.norm()];
        self.rounding += bound(aa.norm(), [size_a; 2], [da; 2])
            + 2.0 * bound(ba.norm(), [size_a, size_b], [da, db])
            + bound(bb.norm(), [size_b; 2], [db; 2]);
    }

    /// Bounds the errors of r′ and r″.
    fn errors(&self, station: &CableStation) -> [f64; 2] {
        let sum = |weights: &[f64; 4]| weights.iter().zip(self.sizes).map(|(w, size)| w.abs() * size).sum();
        [&station.first, &station.second].map(sum)
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
