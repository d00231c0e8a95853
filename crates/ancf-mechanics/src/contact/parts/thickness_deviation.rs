use nalgebra::{Matrix2, Vector2, Vector3};

use crate::kinematics::OffsetValues;

/// Places of an element at which the deviation is evaluated, along ξ and η.
const PLACES: [f64; 3] = [0.25, 0.5, 0.75];

/// Returns the places of an element at which the deviation is evaluated.
pub(super) fn places() -> impl Iterator<Item = [f64; 2]> {
    PLACES.into_iter().flat_map(|y| PLACES.into_iter().map(move |x| [x, y]))
}

/// Returns the relative deviation of the surface that is touched from half the thickness: by its interpolation, and by its slope.
///
/// The envelope of balls whose radius e rises by s per length is at e/√(1 − s²) from the middle surface with the tangents r_ξ and r_η.
/// `radii` are the smallest and the exact half thickness.
pub(super) fn thickness_deviation([t, s]: [&Vector3<f64>; 2], e: &OffsetValues, radii: [f64; 2]) -> f64 {
    let metric = Matrix2::new(t.dot(t), t.dot(s), t.dot(s), s.dot(s));
    let slopes = Vector2::new(e[1], e[2]);
    let rise = metric.try_inverse().map_or(0.0, |inverse| slopes.dot(&(inverse * slopes)));
    let [smallest, exact] = radii;
    ((smallest + e[0]) / (1.0 - rise).max(0.0).sqrt() / exact - 1.0).abs()
}
