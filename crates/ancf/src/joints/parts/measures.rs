//! Equations of joints between two attachments, as measures: directions are those of the second unless said.

use ancf_mechanics::bodies::across;
use ancf_mechanics::constraints::{Measure, Part};
use ancf_mechanics::kinematics::{Attachment, Marker};
use nalgebra::Vector3;

/// Name of the equations that constrain the position.
pub(crate) const POSITION: &str = "position";
/// Name of the equations that constrain a point to a line.
pub(crate) const GUIDE: &str = "guide";
/// Name of the equations that keep axes parallel.
pub(crate) const AXIS: &str = "axis";

/// r_a − r_b.
pub(crate) fn apart(a: &Attachment, b: &Attachment) -> Marker {
    Marker::combined([(1.0, &a.point), (-1.0, &b.point)])
}

/// n·(r_a − r_b): how far a is along a direction.
pub(crate) fn along(a: &Attachment, b: &Attachment, n: Vector3<f64>) -> Measure {
    Measure::new([(1.0, Part::Other(&b.direction(n)), Part::Point(&apart(a, b)))])
}

/// The points stay together.
pub(crate) fn meeting(a: &Attachment, b: &Attachment) -> Vec<Measure> {
    let apart = apart(a, b);
    let row = |axis| Measure::new([(1.0, Part::Other(&Marker::fixed(axis)), Part::Point(&apart))]);
    [Vector3::x(), Vector3::y(), Vector3::z()].map(row).into()
}

/// a stays on the line through b along an axis.
pub(crate) fn on_line(a: &Attachment, b: &Attachment, axis: Vector3<f64>) -> Vec<Measure> {
    across(axis).map(|normal| along(a, b, normal)).into()
}

/// x·y: the angle between a direction of a and one of b.
fn angle(a: &Attachment, b: &Attachment, x: Vector3<f64>, y: Vector3<f64>) -> Measure {
    Measure::new([(1.0, Part::Direction(&a.direction(x)), Part::Other(&b.direction(y)))])
}

/// An axis of a stays along that of b.
pub(crate) fn parallel(a: &Attachment, b: &Attachment, axis: Vector3<f64>) -> Vec<Measure> {
    across(axis).map(|normal| angle(a, b, axis, normal)).into()
}

/// a turns about a point and the cross that joins an axis of each.
pub(crate) fn universal(a: &Attachment, b: &Attachment, [x, y]: [Vector3<f64>; 2]) -> Vec<Measure> {
    let mut rows = meeting(a, b);
    rows.push(angle(a, b, x, y));
    rows
}

/// a turns about the axis and moves along it.
pub(crate) fn cylindrical(a: &Attachment, b: &Attachment, axis: Vector3<f64>) -> Vec<Measure> {
    let mut rows = on_line(a, b, axis);
    rows.extend(parallel(a, b, axis));
    rows
}

/// a moves along the axis.
pub(crate) fn prismatic(a: &Attachment, b: &Attachment, axis: Vector3<f64>) -> Vec<Measure> {
    let (mut rows, [x, y]) = (cylindrical(a, b, axis), across(axis));
    rows.push(angle(a, b, x, y));
    rows
}

/// a moves across the normal and turns about it.
pub(crate) fn planar(a: &Attachment, b: &Attachment, normal: Vector3<f64>) -> Vec<Measure> {
    let mut rows = vec![along(a, b, normal)];
    rows.extend(parallel(a, b, normal));
    rows
}

/// d·d/(2 l₀) of two points that are l₀ apart.
pub(crate) fn half_square(a: &Attachment, b: &Attachment) -> (Measure, f64) {
    let apart = apart(a, b);
    let length = apart.reference().norm();
    (Measure::new([(0.5 / length, Part::Point(&apart), Part::Point(&apart))]), length)
}

/// What a bushing resists: b_i·(r_a − r_b), and ψ_k = ½ (a_i·b_j − a_j·b_i), the sine of a rotation about axis k.
pub(crate) fn bushing(a: &Attachment, b: &Attachment) -> [Measure; 6] {
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    let apart = apart(a, b);
    let ([own, other], axis) = ([a, b].map(|end| axes.map(|axis| end.direction(axis))), |k: usize| k % 3);
    std::array::from_fn(|k| {
        if k < 3 {
            return Measure::new([(1.0, Part::Other(&other[k]), Part::Point(&apart))]);
        }
        let (i, j) = (axis(k + 1), axis(k + 2));
        Measure::new([
            (0.5, Part::Direction(&own[i]), Part::Other(&other[j])),
            (-0.5, Part::Direction(&own[j]), Part::Other(&other[i])),
        ])
    })
}

/// p of a, and u, v of b across an axis, u along p in the reference state: the angle about the axis is that from u to p.
pub(crate) fn hinge(a: &Attachment, b: &Attachment, axis: Vector3<f64>) -> [Marker; 3] {
    let [u, _] = across(axis);
    [a.direction(u), b.direction(u), b.direction(axis.cross(&u))]
}
