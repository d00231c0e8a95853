use nalgebra::Vector3;

use super::spline_surface::SplineSurface;

/// Sections for each part of a path between two points.
const PARTS: usize = 16;

/// Surface of a curve that moves along a path without rotation about it, relative to the first point of the curve.
///
/// The frames are those of the double reflection method: their error falls with the fourth power of the distance of the sections.
/// `None` if neighbouring points coincide.
///
/// Source: Wang, Jüttler, Zheng & Liu (2008).
pub(super) fn sweep(profile: &[[f64; 3]], path: &[[f64; 3]]) -> Option<SplineSurface> {
    let origin = Vector3::from(*profile.first()?);
    let curve: Vec<_> = profile.iter().map(|point| Vector3::from(*point) - origin).collect();
    let places = sections(path)?;
    let [start, mut tangent] = *places.first()?;
    let (mut shifted, mut at) = (curve.clone(), start);
    let mut rows = vec![curve];
    for [point, next] in &places[1..] {
        // Two reflections: of the step, then of the tangent.
        let step = point - at;
        let first = reflection(step);
        let second = reflection(next - first(&tangent));
        shifted.iter_mut().for_each(|arm| *arm = second(&first(arm)));
        (at, tangent) = (*point, *next);
        rows.push(shifted.iter().map(|arm| at - start + arm).collect());
    }
    SplineSurface::new(&rows)
}

/// Reflection that reverses a vector; no change for a vector of zero.
fn reflection(normal: Vector3<f64>) -> impl Fn(&Vector3<f64>) -> Vector3<f64> {
    let square = normal.norm_squared();
    move |x| if square > 1e-30 { x - normal * (2.0 * normal.dot(x) / square) } else { *x }
}

/// Points and unit tangents of the spline through the points of a path, relative to the first point.
fn sections(path: &[[f64; 3]]) -> Option<Vec<[Vector3<f64>; 2]>> {
    let first = Vector3::from(*path.first()?);
    // The spline of a ruled surface along the path.
    let row = |shift: f64| {
        path.iter().map(|point| Vector3::from(*point) - first + Vector3::repeat(shift)).collect()
    };
    let size = path.iter().map(|point| (Vector3::from(*point) - first).norm()).fold(0.0, f64::max);
    let ruled = SplineSurface::new(&[row(0.0), row(size)])?;
    let count = if path.len() == 2 { 1 } else { PARTS * (path.len() - 1) };
    let place = |k: usize| {
        let [point, along, ..] = ruled.at([k as f64 / count as f64, 0.0]);
        [point, along.normalize()]
    };
    Some((0..=count).map(place).collect())
}
