//! Equations of joints between two attachments, as measures: directions belong to the second attachment unless stated otherwise.

use ancf_mechanics::bodies::normals_to;
use ancf_mechanics::constraints::{BilinearMeasure, MeasureFactor};
use ancf_mechanics::kinematics::{Attachment, BodyVector, Directions};
use nalgebra::Vector3;

/// Cosine of the angle between directions that are nearly parallel. At most one of three orthonormal vectors is.
const PARALLEL: f64 = 0.8;
/// Name of the equations that constrain the position.
pub(crate) const POSITION: &str = "position";
/// Name of the equations that constrain a point to a line.
pub(crate) const GUIDE: &str = "guide";
/// Name of the equations that keep axes parallel.
pub(crate) const AXIS: &str = "axis";

/// r_a − r_b.
pub(crate) fn apart(a: &Attachment, b: &Attachment) -> BodyVector {
    BodyVector::combined([(1.0, &a.point), (-1.0, &b.point)])
}

/// n·(r_a − r_b): how far a is along a direction.
pub(crate) fn along(a: &Attachment, b: &Attachment, n: Vector3<f64>) -> BilinearMeasure {
    BilinearMeasure::new([(1.0, MeasureFactor::Other(&b.direction(n)), MeasureFactor::Point(&apart(a, b)))])
}

/// Coincidence of the points.
pub(crate) fn meeting(a: &Attachment, b: &Attachment) -> Vec<BilinearMeasure> {
    let apart = apart(a, b);
    let row = |axis| {
        BilinearMeasure::new([(
            1.0,
            MeasureFactor::Other(&BodyVector::fixed(axis)),
            MeasureFactor::Point(&apart),
        )])
    };
    [Vector3::x(), Vector3::y(), Vector3::z()].map(row).into()
}

/// a stays on the line through b along an axis.
pub(crate) fn on_line(a: &Attachment, b: &Attachment, axis: Vector3<f64>) -> Vec<BilinearMeasure> {
    normals_to(axis).map(|normal| along(a, b, normal)).into()
}

/// x·y: the angle between a direction of a and one of b.
pub(crate) fn angle(a: &Attachment, b: &Attachment, x: Vector3<f64>, y: Vector3<f64>) -> BilinearMeasure {
    BilinearMeasure::new([(
        1.0,
        MeasureFactor::Direction(&a.direction(x)),
        MeasureFactor::Other(&b.direction(y)),
    )])
}

/// Constant direction of an axis of a relative to b.
pub(crate) fn parallel(a: &Attachment, b: &Attachment, axis: Vector3<f64>) -> Vec<BilinearMeasure> {
    normals_to(axis).map(|normal| angle(a, b, axis, normal)).into()
}

/// a turns about a point and the cross that joins an axis of each.
pub(crate) fn universal(a: &Attachment, b: &Attachment, [x, y]: [Vector3<f64>; 2]) -> Vec<BilinearMeasure> {
    let mut rows = meeting(a, b);
    rows.push(angle(a, b, x, y));
    rows
}

/// a turns about the axis and moves along it.
pub(crate) fn cylindrical(a: &Attachment, b: &Attachment, axis: Vector3<f64>) -> Vec<BilinearMeasure> {
    let mut rows = on_line(a, b, axis);
    rows.extend(parallel(a, b, axis));
    rows
}

/// a moves along the axis.
pub(crate) fn prismatic(a: &Attachment, b: &Attachment, axis: Vector3<f64>) -> Vec<BilinearMeasure> {
    let (mut rows, [x, y]) = (cylindrical(a, b, axis), normals_to(axis));
    rows.push(angle(a, b, x, y));
    rows
}

/// a moves across the normal and turns about it.
pub(crate) fn planar(a: &Attachment, b: &Attachment, normal: Vector3<f64>) -> Vec<BilinearMeasure> {
    let mut rows = vec![along(a, b, normal)];
    rows.extend(parallel(a, b, normal));
    rows
}

/// d·d/(2 l₀) of two points that are l₀ apart.
pub(crate) fn half_square(a: &Attachment, b: &Attachment) -> (BilinearMeasure, f64) {
    let apart = apart(a, b);
    let length = apart.reference().norm();
    (
        BilinearMeasure::new([(0.5 / length, MeasureFactor::Point(&apart), MeasureFactor::Point(&apart))]),
        length,
    )
}

/// b_i·(r_a − r_b): displacements of a bushing.
pub(crate) fn displacements(a: &Attachment, b: &Attachment) -> [BilinearMeasure; 3] {
    [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| along(a, b, axis))
}

/// x·e, x·u and x·v of the axis x = e of a and the axes e, u, v of b.
pub(crate) fn swing(a: &Attachment, b: &Attachment, [e, u, v]: [Vector3<f64>; 3]) -> [BilinearMeasure; 3] {
    [e, u, v].map(|axis| angle(a, b, e, axis))
}

/// C − 1 and the components of m = sin β n, for the rotation of a relative to b by β about n, in the axes of b.
pub(crate) fn rotation_vector(
    a: &Attachment,
    b: &Attachment,
    axes: [Vector3<f64>; 3],
) -> (BilinearMeasure, [BilinearMeasure; 3]) {
    let own = axes.map(|axis| a.direction(axis));
    let other = axes.map(|axis| b.direction(axis));
    let product = |i: usize, j: usize| (MeasureFactor::Direction(&own[i]), MeasureFactor::Other(&other[j]));
    let sum = |parts: &[(f64, usize, usize)]| {
        BilinearMeasure::new(parts.iter().map(|&(factor, i, j)| {
            let (x, y) = product(i, j);
            (factor, x, y)
        }))
    };
    let sines = [0, 1, 2].map(|k| sum(&[(0.5, (k + 1) % 3, (k + 2) % 3), (-0.5, (k + 2) % 3, (k + 1) % 3)]));
    (sum(&[(0.5, 0, 0), (0.5, 1, 1), (0.5, 2, 2)]), sines)
}

/// p of a, and u, v of b across an axis, u along p in the reference state: the angle about the axis is that from u to p.
///
/// At the start of a motion, small corrections depend on u. It therefore follows a section, if there is one, and not the global
/// axes.
pub(crate) fn hinge(a: &Attachment, b: &Attachment, axis: Vector3<f64>) -> [BodyVector; 3] {
    let of_section = [a, b].into_iter().find_map(|end| match &end.directions {
        Directions::Section(_, frame) | Directions::Surface(frame) => {
            Some(normal_along(axis, frame.reference()))
        }
        _ => None,
    });
    let u = of_section.unwrap_or_else(|| normals_to(axis)[0]);
    [a.direction(u), b.direction(u), b.direction(axis.cross(&u))]
}

/// Unit vector normal to an axis, along the first of three orthonormal vectors that is not nearly parallel to it.
fn normal_along(axis: Vector3<f64>, frame: &[Vector3<f64>; 3]) -> Vector3<f64> {
    let guide = frame.iter().find(|direction| direction.dot(&axis).abs() < PARALLEL).unwrap_or(&frame[2]);
    (guide - axis * axis.dot(guide)).normalize()
}
