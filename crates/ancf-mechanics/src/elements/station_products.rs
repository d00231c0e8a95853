//! Products with the stiffness of a beam element, from the directors of the columns.

use ancf_solver::equations::{Local, ProductColumn};
use nalgebra::Vector3;

use super::beam::{BeamElement, vectors};
use super::station::{BeamStation, RelativeVectors};
use crate::kinematics::Interpolation;
use crate::sections::{DIRECTORS, Directors, NO_STIFFNESS, Stiffness};

/// Multiple of ε |H| |d|² that bounds the rounding errors of dᵀ H d.
const ROUNDING: f64 = 4.0;

impl<const N: usize, S: Interpolation<N>> BeamElement<N, S> {
    /// Adds K x for the columns x: the stiffness of each station times the directors of x, without the large stiffness of the
    /// vectors.
    pub(super) fn add_stiffness_products(&self, at: &Local<'_>, columns: &mut [ProductColumn]) {
        let (q, v) = (RelativeVectors::new::<S>(&vectors(at.q)), self.moving(at));
        let relative: Vec<_> = columns.iter().map(|column| vectors::<N>(&column.x)).collect();
        let mut h = NO_STIFFNESS;
        for station in &self.profile.stations {
            let g0 = station.reference(&self.frame);
            let u = station.directors::<S>(&q);
            station.stiffness::<S>(&g0, &u, v.as_ref(), [1.0, 0.0], &mut h);
            let blocks = StationBlocks::new(station, &h);
            for (column, x) in columns.iter_mut().zip(&relative) {
                let d = station.directors::<S>(&RelativeVectors::new::<S>(x));
                let mut force = [Vector3::zeros(); N];
                station.distribute(&blocks.times(&d), &mut force);
                column.product.iter_mut().zip(force.iter().flatten()).for_each(|(product, f)| *product += f);
                let errors = station.director_rounding(&x.map(|x| x.norm()));
                column.rounding += station.weight * blocks.rounding(&d, &errors);
            }
        }
    }
}

/// Stiffness of the directors of a station with its nonzero blocks.
struct StationBlocks<'a> {
    h: &'a Stiffness,
    /// Row, column and norm of the nonzero blocks.
    blocks: Vec<(usize, usize, f64)>,
}

impl<'a> StationBlocks<'a> {
    fn new<const N: usize>(station: &BeamStation<N>, h: &'a Stiffness) -> Self {
        let reach = station.reach();
        let all = (0..reach).flat_map(|i| (0..reach).map(move |j| (i, j, h[i][j].norm())));
        Self { h, blocks: all.filter(|block| block.2 != 0.0).collect() }
    }

    /// Computes H d.
    fn times(&self, d: &Directors) -> Directors {
        let mut product = [Vector3::zeros(); DIRECTORS];
        self.blocks.iter().for_each(|&(i, j, _)| product[i] += self.h[i][j] * d[j]);
        product
    }

    /// Bounds the rounding error of dᵀ H d for the norms of the errors of d.
    fn rounding(&self, d: &Directors, errors: &[f64; DIRECTORS]) -> f64 {
        let sizes = d.map(|d| d.norm());
        let of = |&(i, j, norm): &(usize, usize, f64)| {
            let of_errors = errors[i] * sizes[j] + sizes[i] * errors[j] + errors[i] * errors[j];
            norm * (of_errors + ROUNDING * f64::EPSILON * sizes[i] * sizes[j])
        };
        self.blocks.iter().map(of).sum()
    }
}
