use nalgebra::Vector3;

use crate::errors::{Finding, finding, number};

/// Cosine of the angle beyond which two axes are not perpendicular.
const SKEW: f64 = 1e-6;

/// Directions of the x- and y-axis of a joint; the global ones by default.
pub(super) type StatedAxes = [Option<[f64; 3]>; 2];

/// Unit vectors of the axes of a joint with perpendicular directions. The z-axis follows by the right-hand rule.
pub(super) fn frame([x, y]: StatedAxes) -> [Vector3<f64>; 3] {
    let unit = |axis: Option<[f64; 3]>, default| axis.map_or(default, |axis| Vector3::from(axis).normalize());
    let (x, y) = (unit(x, Vector3::x()), unit(y, Vector3::y()));
    [x, y, x.cross(&y)]
}

/// Stated directions with their keys.
pub(super) fn directions([x, y]: StatedAxes) -> Vec<(&'static str, [f64; 3])> {
    let [x, y] = [("x_axis", x), ("y_axis", y)].map(|(key, axis)| axis.map(|axis| (key, axis)));
    x.into_iter().chain(y).collect()
}

/// Finding if the axes are not perpendicular. Zero directions are reported by another check.
pub(super) fn rule_of_axes(path: &str, axes: StatedAxes) -> Option<Finding> {
    if directions(axes).iter().any(|(_, axis)| Vector3::from(*axis).norm() == 0.0) {
        return None;
    }
    let [x, y, _] = frame(axes);
    let cosine = x.dot(&y);
    let angle = number(cosine.clamp(-1.0, 1.0).acos().to_degrees());
    let key = if axes[1].is_some() { "y_axis" } else { "x_axis" };
    let expected =
        "a direction perpendicular to the other axis; `x_axis` and `y_axis` are the global axes by default";
    let error = finding(format!("{path}.{key}"), format!("an angle of {angle}° to the other axis"), expected);
    (cosine.abs() > SKEW).then(|| error.rests_on(["x_axis", "y_axis"].map(|key| format!("{path}.{key}"))))
}
