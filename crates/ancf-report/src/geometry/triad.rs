//! Orthonormal triads of directions that may be degenerate.

use ancf::mechanics::bodies::normals_to;
use nalgebra::Vector3;

/// Three orthonormal directors.
pub(crate) type Triad = [Vector3<f64>; 3];

/// Returns the triad with a first direction and, as closely as possible, a second one.
///
/// Without a first direction, the triad is that of the global axes.
pub(crate) fn triad(first: Vector3<f64>, second: Vector3<f64>) -> Triad {
    let Some(x) = unit(first) else { return [Vector3::x(), Vector3::y(), Vector3::z()] };
    let y = unit(second - x * x.dot(&second)).unwrap_or_else(|| normals_to(x)[0]);
    [x, y, x.cross(&y)]
}

/// Normalises a vector; `None` if its length is zero or not finite.
pub(crate) fn unit(x: Vector3<f64>) -> Option<Vector3<f64>> {
    let length = x.norm();
    (length.is_finite() && length > 1e-12).then(|| x / length)
}
