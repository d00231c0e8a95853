//! Products with the stiffness of a station, from its directors.

use ancf_solver::equations::ProductColumn;
use nalgebra::Vector3;

use super::station::{BeamStation, RelativeVectors};
use crate::kinematics::Interpolation;
use crate::sections::{DIRECTORS, Directors, Stiffness};

/// Multiple of ε |H| |d|² that bounds the rounding errors of dᵀ H d.
const ROUNDING: f64 = 4.0;

/// Stiffness of the directors of a station with its nonzero blocks.
pub(super) struct StationBlocks<'a> {
    h: &'a Stiffness,
    /// Row, column and norm of the nonzero blocks.
    blocks: Vec<(usize, usize, f64)>,
}

impl<'a> StationBlocks<'a> {
    pub(super) fn new<const N: usize>(station: &BeamStation<N>, h: &'a Stiffness) -> Self {
        let reach = station.reach();
        let all = (0..reach).flat_map(|i| (0..reach).map(move |j| (i, j, h[i][j].norm())));
        Self { h, blocks: all.filter(|block| block.2 != 0.0).collect() }
    }

    /// Adds the forces H d on the vectors of an element, for the directors d of a column x, with a bound of their rounding error.
    pub(super) fn add_product<const N: usize, S: Interpolation<N>>(
        &self,
        station: &BeamStation<N>,
        x: &[Vector3<f64>; N],
        column: &mut ProductColumn,
    ) {
        let d = station.directors::<S>(&RelativeVectors::new::<S>(x));
        let mut force = [Vector3::zeros(); N];
        station.distribute(&self.times(&d), &mut force);
        column.product.iter_mut().zip(force.iter().flatten()).for_each(|(product, f)| *product += f);
        let errors = station.director_rounding(&x.map(|x| x.norm()));
        column.rounding += station.weight * self.rounding(&d, &errors);
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
