//! Products with the stiffness of a cable element, from the strains of the columns.

use ancf_solver::equations::{Local, ProductColumn, Weights};
use nalgebra::Vector3;

use super::cable::Cable12;
use super::cable_profile::CableStation;
use super::cable_step::vectors;
use crate::kinematics::BendBlocks;

/// Multiple of ε |H| |d|² that bounds the rounding errors of dᵀ H d.
const ROUNDING: f64 = 4.0;

impl Cable12 {
    /// Adds K x for the columns x: the stiffness of each station times r′ and r″ of x, without the large stiffness of the vectors.
    pub(super) fn add_stiffness_products(&self, at: &Local<'_>, columns: &mut [ProductColumn]) {
        let (profile, q, v) = (&*self.profile, vectors(at.q), vectors(at.v));
        let columns: &mut Vec<_> = &mut columns.iter_mut().map(Column::new).collect();
        for station in profile.axial() {
            let h = self.axial_stiffness(station, &q, &v, Weights::STIFFNESS) * station.weight;
            let size = h.norm();
            for column in &mut *columns {
                let (d, [du, _]) = (station.first(&column.x), column.errors(station));
                let force = h * d;
                column.forces.iter_mut().zip(station.first).for_each(|(sum, s)| *sum += force * s);
                let d = d.norm();
                column.rounding += bound(size, [d, d], [du, du]);
            }
        }
        for station in profile.bending() {
            let h = self.bending_stiffness(station, &q, &v, Weights::STIFFNESS).scaled(station.weight);
            let BendBlocks { aa, ba, bb } = &h;
            let [of_aa, of_ba, of_bb] = [aa, ba, bb].map(|block| block.norm());
            for column in &mut *columns {
                let ([a, b], [da, db]) = (station.both(&column.x), column.errors(station));
                let (of_a, of_b) = (aa * a + ba.tr_mul(&b), ba * a + bb * b);
                for (i, sum) in column.forces.iter_mut().enumerate() {
                    *sum += of_a * station.first[i] + of_b * station.second[i];
                }
                let [size_a, size_b] = [a.norm(), b.norm()];
                column.rounding += bound(of_aa, [size_a, size_a], [da, da])
                    + 2.0 * bound(of_ba, [size_a, size_b], [da, db])
                    + bound(of_bb, [size_b, size_b], [db, db]);
            }
        }
        columns.drain(..).for_each(Column::finish);
    }
}

/// Vectors of a column, with the sizes of their rounding errors, and the sums of the forces on them.
struct Column<'a> {
    target: &'a mut ProductColumn,
    x: [Vector3<f64>; 4],
    sizes: [f64; 4],
    forces: [Vector3<f64>; 4],
    rounding: f64,
}

impl<'a> Column<'a> {
    fn new(target: &'a mut ProductColumn) -> Self {
        let x = vectors(&target.x);
        let sizes = x.map(|x| f64::EPSILON * x.norm());
        Self { target, x, sizes, forces: [Vector3::zeros(); 4], rounding: 0.0 }
    }

    /// Bounds the errors of r′ and r″.
    fn errors(&self, station: &CableStation) -> [f64; 2] {
        let sum = |weights: &[f64; 4]| weights.iter().zip(self.sizes).map(|(w, size)| w.abs() * size).sum();
        [&station.first, &station.second].map(sum)
    }

    fn finish(self) {
        let rows = self.target.product.iter_mut().zip(self.forces.iter().flatten());
        rows.for_each(|(product, force)| *product += force);
        self.target.rounding += self.rounding;
    }
}

/// Bounds the rounding error of xᵀ H y for the norms of H, x and y and of the errors of x and y.
fn bound(h: f64, [x, y]: [f64; 2], [dx, dy]: [f64; 2]) -> f64 {
    h * (dx * y + x * dy + dx * dy + ROUNDING * f64::EPSILON * x * y)
}
