//! Integration points of sections, in groups of four that are symmetric about both axes.

use std::f64::consts::PI;

use ancf_mechanics::sections::SectionPoint;

/// Points of a quadrant and their images about both axes.
pub(super) fn mirrored(quadrant: [SectionPoint; 4]) -> Vec<SectionPoint> {
    let images = |SectionPoint { y, z, weight }: SectionPoint| {
        [(y, z), (-y, z), (-y, -z), (y, -z)].map(|(y, z)| SectionPoint { y, z, weight })
    };
    quadrant.into_iter().flat_map(images).collect()
}

/// Sixteen points of an ellipse with a similar bore of relative size `bore`.
///
/// Two Gauss points in the square of the radius on each of eight rays: exact for degree seven.
///
/// Source: Abramowitz & Stegun (1964), table 25.4; Stroud (1971), chapter 2, for products in polar coordinates.
pub(super) fn elliptic_points(height: f64, width: f64, bore: f64) -> Vec<SectionPoint> {
    let share = (1.0 - bore) * (1.0 + bore);
    let weight = PI * height * width * share / 64.0;
    let point = |t: f64, angle: f64| {
        let radius = (1.0 - share * t).sqrt();
        SectionPoint { y: 0.5 * height * radius * angle.cos(), z: 0.5 * width * radius * angle.sin(), weight }
    };
    let (less, more) = (0.5 - 3.0_f64.sqrt() / 6.0, 0.5 + 3.0_f64.sqrt() / 6.0);
    let (low, high) = (PI / 8.0, 3.0 * PI / 8.0);
    mirrored([point(less, low), point(less, high), point(more, low), point(more, high)])
}
