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
        for station in profile.axial() {
            let h = self.axial_stiffness(station, &q, &v, Weights::STIFFNESS) * station.weight;
            let size = h.norm();
            for column in &mut *columns {
                let x = vectors(&column.x);
                let (d, [du, _]) = (station.first(&x), station.rounding(&x));
                spread(station, [h * d, Vector3::zeros()], column);
                column.rounding += bound(size, [d.norm(), d.norm()], [du, du]);
            }
        }
        for station in profile.bending() {
            let h = self.bending_stiffness(station, &q, &v, Weights::STIFFNESS).scaled(station.weight);
            let BendBlocks { aa, ba, bb } = &h;
            let [of_aa, of_ba, of_bb] = [aa, ba, bb].map(|block| block.norm());
            for column in &mut *columns {
                let x = vectors(&column.x);
                let ([a, b], [da, db]) = (station.both(&x), station.rounding(&x));
                spread(station, [aa * a + ba.tr_mul(&b), ba * a + bb * b], column);
                let [size_a, size_b] = [a.norm(), b.norm()];
                column.rounding += bound(of_aa, [size_a, size_a], [da, da])
                    + 2.0 * bound(of_ba, [size_a, size_b], [da, db])
                    + bound(of_bb, [size_b, size_b], [db, db]);
            }
        }
    }
}

/// Bounds the rounding error of xᵀ H y for the norms of H, x and y and of the errors of x and y.
fn bound(h: f64, [x, y]: [f64; 2], [dx, dy]: [f64; 2]) -> f64 {
    h * (dx * y + x * dy + dx * dy + ROUNDING * f64::EPSILON * x * y)
}

/// Distributes forces on r′ and r″ to the vectors.
fn spread(station: &CableStation, [of_a, of_b]: [Vector3<f64>; 2], column: &mut ProductColumn) {
    for i in 0..4 {
        let force = of_a * station.first[i] + of_b * station.second[i];
        column.product[3 * i..3 * i + 3].iter_mut().zip(&force).for_each(|(product, force)| *product += force);
    }
}
