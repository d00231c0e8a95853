//! Numbers that may carry derivatives, and tangents over markers.

use ancf_solver::equations::LocalMatrix;
use nalgebra::{SMatrix, Vector3};
use num_dual::DualNum;

use super::marker::Marker;

/// Real number with or without derivatives: `f64` or a dual number.
pub trait Real: DualNum<Primitive = f64> + Copy {}

impl<T: DualNum<Primitive = f64> + Copy> Real for T {}

/// Converts a constant vector.
pub(crate) fn constant<D: Real>(x: &Vector3<f64>) -> Vector3<D> {
    x.map(D::from)
}

/// Adds the symmetric part of w H to a tangent, H = ∂(f₁, .., f_n)/∂(x₁, .., x_n) over markers, in 3 × 3 blocks.
pub fn add_symmetric<const N: usize>(
    markers: &[&Marker],
    h: &SMatrix<f64, N, N>,
    w: f64,
    k: &mut LocalMatrix<'_>,
) {
    for (i, a) in markers.iter().enumerate() {
        for (j, b) in markers.iter().enumerate() {
            let block = |i: usize, j: usize| h.fixed_view::<3, 3>(3 * i, 3 * j);
            let symmetric = (block(i, j) + block(j, i).transpose()) * (0.5 * w);
            a.add_lower_product(b, &symmetric, k);
        }
    }
}

/// Skew entries of this size, relative to H, are rounding errors.
pub(super) const NEGLIGIBLE: f64 = 1e-13;

/// Visits the lower entries of the skew part of w H, with the meaning of [`add_symmetric`].
pub(crate) fn visit_skew<const N: usize>(
    markers: &[&Marker],
    h: &SMatrix<f64, N, N>,
    w: f64,
    visit: &mut dyn FnMut(usize, usize, f64),
) {
    let negligible = NEGLIGIBLE * w.abs() * h.amax();
    for (i, a) in markers.iter().enumerate() {
        for (j, b) in markers.iter().enumerate() {
            let block = |i: usize, j: usize| h.fixed_view::<3, 3>(3 * i, 3 * j);
            let skew = (block(i, j) - block(j, i).transpose()) * (0.5 * w);
            a.product(b, &skew, |i, j, value| {
                if i > j && value.abs() > negligible {
                    visit(i, j, value);
                }
            });
        }
    }
}
