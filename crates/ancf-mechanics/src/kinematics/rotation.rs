//! Rotations between two states, relative to the largest one of a load increment.

use std::f64::consts::PI;

use nalgebra::Vector3;

/// Largest rotation of a section or a body in one load increment. Loads bend a cantilever by up to π/2 in one increment.
const LARGEST_ROTATION: f64 = 2.0 * PI / 3.0;
/// Largest prescribed rotation in one load increment.
const LARGEST_DRIVEN_ROTATION: f64 = PI / 6.0;

/// Returns the largest angle between directions before and after, relative to its limit.
pub(crate) fn relative_rotation(directions: impl IntoIterator<Item = [Vector3<f64>; 2]>) -> f64 {
    let angle = |[before, after]: [Vector3<f64>; 2]| before.cross(&after).norm().atan2(before.dot(&after));
    directions.into_iter().map(angle).fold(0.0, f64::max) / LARGEST_ROTATION
}

/// Returns the size of a prescribed rotation, relative to its limit.
pub(crate) fn relative_driven_rotation(angle: f64) -> f64 {
    angle.abs() / LARGEST_DRIVEN_ROTATION
}
