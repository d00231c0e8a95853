use nalgebra::{Matrix2, Vector2, Vector3};

use super::closest_point::{SurfaceSlopes, SurfaceValues, derivatives, least};

/// Values of e, e_ξ, e_η, e_ξξ, e_ηη and e_ξη, with the distance e of an offset from its surface.
pub(crate) type OffsetValues = [f64; 6];

/// Finds (ξ, η) of the least distance |d| − e from the offset of a surface, 0 ≤ ξ, η ≤ 1, with d = p − r(ξ, η).
///
/// The offset is the envelope of the balls with the radius e about the points of the surface. It exists where e varies by less than
/// the length along the surface.
pub(crate) fn closest_offset_point(
    point: &Vector3<f64>,
    start: [f64; 2],
    surface: impl Fn([f64; 2]) -> (SurfaceValues, OffsetValues),
) -> [f64; 2] {
    let distance = |(values, e): &(SurfaceValues, OffsetValues)| (point - values[0]).norm() - e[0];
    least(start, surface, distance, |(values, e)| offset_derivatives(&(point - values[0]), values, e))
}

/// Computes the negative gradient and the second derivative of |d| − e, both multiplied by |d|, and the metric of the surface.
///
/// With n = d/|d| they are d·r_α + |d| e_α and r_α·(I − n nᵀ) r_β − d·r_αβ − |d| e_αβ.
fn offset_derivatives(d: &Vector3<f64>, values: &SurfaceValues, e: &OffsetValues) -> SurfaceSlopes {
    let [_, a, b, aa, bb, ab] = values;
    let metric = Matrix2::new(a.dot(a), a.dot(b), a.dot(b), b.dot(b));
    let (distance, [x, y]) = (d.norm(), along(d, [a, b]));
    let twist = x.dot(&y) - d.dot(ab) - distance * e[5];
    let bent = Matrix2::new(
        x.dot(&x) - d.dot(aa) - distance * e[3],
        twist,
        twist,
        y.dot(&y) - d.dot(bb) - distance * e[4],
    );
    (Vector2::new(d.dot(a) + distance * e[1], d.dot(b) + distance * e[2]), bent, metric)
}

/// Computes the derivatives of the distance from a surface, or from its offset, and the parts of r_ξ and r_η along which the gap has no
/// derivative.
pub(crate) fn gap_slopes(
    d: &Vector3<f64>,
    values: &SurfaceValues,
    offset: Option<OffsetValues>,
) -> (SurfaceSlopes, [Vector3<f64>; 2]) {
    let tangents = [&values[1], &values[2]];
    match offset {
        None => (derivatives(d, values), tangents.map(Vector3::clone)),
        Some(e) => (offset_derivatives(d, values, &e), along(d, tangents)),
    }
}

/// Returns the parts of tangents normal to d.
fn along(d: &Vector3<f64>, tangents: [&Vector3<f64>; 2]) -> [Vector3<f64>; 2] {
    let n = d.try_normalize(0.0).unwrap_or_else(Vector3::zeros);
    tangents.map(|t| t - n * n.dot(t))
}
