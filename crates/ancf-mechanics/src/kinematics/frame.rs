//! Section frame from the directors d = r_y, e = r_z, for numbers that may carry derivatives.

use ancf_solver::equations::LocalMatrix;
use nalgebra::{Matrix3, SMatrix, Vector3};
use num_dual::DualNum;

use super::marker::Marker;

/// Real number with or without derivatives.
pub(crate) trait Real: DualNum<Primitive = f64> + Copy {}

impl<T: DualNum<Primitive = f64> + Copy> Real for T {}

fn unit<D: Real>(x: Vector3<D>) -> Vector3<D> {
    let length = x.dot(&x).sqrt();
    x.map(|x| x / length)
}

/// Converts a constant vector.
pub(crate) fn constant<D: Real>(x: &Vector3<f64>) -> Vector3<D> {
    x.map(D::from)
}

/// Computes the orthonormal section frame: normal n = d × e/|d × e|, and y and z that divide the skew of d and e
/// equally.
///
/// Corresponds to [`BeamMesh::section_frame`](crate::bodies::BeamMesh::section_frame).
pub(crate) fn section_frame<D: Real>(d: Vector3<D>, e: Vector3<D>) -> [Vector3<D>; 3] {
    let normal = unit(d.cross(&e));
    let y = unit(unit(d) + unit(e.cross(&normal)));
    [normal, y, normal.cross(&y)]
}

/// Returns the components of a global vector in the section frame.
pub(crate) fn components(d: Vector3<f64>, e: Vector3<f64>, global: &Vector3<f64>) -> Vector3<f64> {
    Matrix3::from_columns(&section_frame(d, e)).transpose() * global
}

/// Returns the global vector with the given components in the section frame.
pub(crate) fn turned<D: Real>(d: Vector3<D>, e: Vector3<D>, components: &Vector3<f64>) -> Vector3<D> {
    let [n, y, z] = section_frame(d, e);
    n.map(|x| x * components.x) + y.map(|x| x * components.y) + z.map(|x| x * components.z)
}

/// Adds the symmetric part of w H to a tangent, H = ∂(f₁, .., f_n)/∂(x₁, .., x_n) over markers, in 3 × 3 blocks.
pub fn add_symmetric<const N: usize>(
    markers: &[&Marker],
    h: &SMatrix<f64, N, N>,
    w: f64,
    k: &mut LocalMatrix<'_>,
) {
    let mut add = |i: usize, j: usize, value: f64| {
        if i >= j {
            k.add(i, j, value);
        }
    };
    for (i, a) in markers.iter().enumerate() {
        for (j, b) in markers.iter().enumerate() {
            let block = |i: usize, j: usize| h.fixed_view::<3, 3>(3 * i, 3 * j);
            let symmetric = (block(i, j) + block(j, i).transpose()) * (0.5 * w);
            a.product(b, &symmetric, &mut add);
        }
    }
}

/// Skew entries of this size, relative to H, are rounding errors.
const NEGLIGIBLE: f64 = 1e-13;

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
