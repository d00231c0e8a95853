//! Motions through contact partners.

use nalgebra::Vector3;

use crate::contact::parts::{ContactPoint, SMALLEST_DISTANCE, SPACING};

/// Returns the part of a straight line between two vectors at which it is nearest to the origin.
fn nearest(from: &Vector3<f64>, to: &Vector3<f64>) -> f64 {
    let way = to - from;
    let square = way.norm_squared();
    if square > 0.0 { (-from.dot(&way) / square).clamp(0.0, 1.0) } else { 0.0 }
}

/// Returns true if a point passes through a convex obstacle on a straight line between two radial vectors.
///
/// The vectors are relative to the sum of the radii. A point that is too deep at the start may leave on its side.
fn passes(from: &Vector3<f64>, to: &Vector3<f64>) -> bool {
    let nearest = (from + (to - from) * nearest(from, to)).norm();
    nearest < SMALLEST_DISTANCE
        && (nearest < from.norm() * (1.0 - 1e-9))
        && (from.norm() >= SMALLEST_DISTANCE || from.dot(to) < 0.0)
}

/// Returns a point of a line of points that passes through an obstacle between two states, from the radial vectors of its points.
///
/// Positions between two points of the line are interpolated, since an obstacle may fit between them.
pub(super) fn obstacle_crossing<'a>(
    points: impl Iterator<Item = (&'a ContactPoint, [Vector3<f64>; 2])>,
) -> Option<&'a ContactPoint> {
    let mut last: Option<[Vector3<f64>; 2]> = None;
    for (point, here) in points {
        let [before, after] = last.unwrap_or(here);
        let spacing = (here[0] - before).norm().max((here[1] - after).norm());
        let count = (spacing / SPACING).ceil().clamp(1.0, 1e4);
        for k in 1..=count as usize {
            let part = k as f64 / count;
            let at = |last: &Vector3<f64>, here: &Vector3<f64>| last + (here - last) * part;
            if passes(&at(&before, &here[0]), &at(&after, &here[1])) {
                return Some(point);
            }
        }
        last = Some(here);
    }
    None
}

/// Returns the position on a straight line between two states at which a point touches a convex obstacle that it does
/// not touch at the ends.
pub(super) fn obstacle_passing(mut points: impl Iterator<Item = [Vector3<f64>; 2]>) -> Option<f64> {
    points.find_map(|[from, to]| {
        let part = nearest(&from, &to);
        let touches = |x: Vector3<f64>| x.norm_squared() < 1.0;
        (touches(from + (to - from) * part) && !touches(from) && !touches(to)).then_some(part)
    })
}
