//! Orthonormal frames that survive numbers which are none.

use ancf::mechanics::across;
use nalgebra::Vector3;

/// Three unit directors.
pub(crate) type Frame = [Vector3<f64>; 3];

/// The global axes.
pub(crate) fn global() -> Frame {
    [Vector3::x(), Vector3::y(), Vector3::z()]
}

/// The orthonormal frame of a first direction and, as near as it can be, a second one.
pub(crate) fn frame(first: Vector3<f64>, second: Vector3<f64>) -> Frame {
    let Some(x) = unit(first) else { return global() };
    let y = unit(second - x * x.dot(&second)).unwrap_or_else(|| across(x)[0]);
    [x, y, x.cross(&y)]
}

/// A vector of length 1, if there is one.
pub(crate) fn unit(x: Vector3<f64>) -> Option<Vector3<f64>> {
    let length = x.norm();
    (length.is_finite() && length > 1e-12).then(|| x / length)
}
