use nalgebra::Vector3;

use super::axis_curve::AxisCurve;
use crate::contact::parts::{END_MARGIN, EndBounds, NODE_TRANSITION};

/// Planes at both ends of an element. A point beyond one of them has no contact with the element, but with a neighbour.
///
/// If d·r′ < 0 for all ξ, the distance |d| from a point increases along the axis. The start is then the closest point, in
/// which the element has no share. This is the case if (p − bⱼ)·hₖ < 0 for all Bézier points bⱼ and their differences hₖ.
/// Neighbours on an axis thus have no terms unless it is folded.
#[derive(Debug)]
pub(super) struct EndPlanes(EndBounds<3>);

impl EndPlanes {
    /// Creates the planes for points within a distance of an element.
    pub(super) fn new(curve: &AxisCurve, ends: [bool; 2], distance: f64) -> Self {
        let (points, margin) = (curve.bezier_points(), END_MARGIN * distance);
        let is_valid = |end: usize| {
            let [_, slope, _] = curve.at(end as f64);
            // The distance has no other minimum at the end, and the margin exceeds the transition at the node.
            !ends[end]
                && distance * curve.bending() < slope.norm_squared()
                && margin > 4.0 * NODE_TRANSITION * slope.norm()
        };
        let differences = [0, 1, 2].map(|k| points[k + 1] - points[k]);
        Self(EndBounds::new(&points, differences, [0, 1].map(is_valid), margin))
    }

    /// Returns true if a point is beyond an end where the beam continues.
    pub(super) fn are_passed(&self, point: &Vector3<f64>) -> bool {
        self.0.are_passed(point)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::parts::Foot;
    use crate::kinematics::ElementAxis;

    /// An element has no share in the contact of points beyond its planes, at any curvature.
    #[test]
    fn points_beyond_have_no_contact() {
        let (mut seed, mut passed, mut kept) = (29_u64, 0, 0);
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 32) as f64 / f64::from(1_u32 << 31) - 1.0
        };
        for case in 0..4000 {
            let mut vector = |size: f64| Vector3::from_fn(|_, _| size * random());
            let straight = [Vector3::zeros(), Vector3::x(), Vector3::x(), Vector3::x()];
            let reference = straight.map(|x| x + vector(0.1)).to_vec();
            let axis = ElementAxis::new(vec![0, 3, 6, 9], reference, [1.0, 1.0], 0.0);
            let curve = AxisCurve::new(&axis, &[0.0; 12], &Vector3::zeros());
            let (point, distance) = (vector(0.3) + Vector3::x() * f64::from(case % 2), 0.2);
            let near = (point - curve.point(curve.closest(&point))).norm() < distance;
            let foot = Foot::on_axis(&point, &curve, 1.0, [false; 2]);
            if EndPlanes::new(&curve, [false; 2], distance).are_passed(&point) {
                passed += usize::from(near);
                assert!(!near || foot.is_none());
            } else {
                kept += usize::from(near && foot.is_some());
            }
        }
        assert!(passed > 20 && kept > 20, "{passed}, {kept}");
    }

    /// A free end has contact with points beyond it.
    #[test]
    fn free_ends_have_contact() {
        let reference = vec![Vector3::zeros(), Vector3::x(), Vector3::x(), Vector3::x()];
        let axis = ElementAxis::new(vec![0, 3, 6, 9], reference, [1.0, 1.0], 0.0);
        let curve = AxisCurve::new(&axis, &[0.0; 12], &Vector3::zeros());
        for (x, end) in [(-0.15, 0), (1.15, 1)] {
            let point = Vector3::new(x, 0.05, 0.0);
            for free in [false, true] {
                let mut ends = [false; 2];
                ends[end] = free;
                assert_eq!(EndPlanes::new(&curve, ends, 0.2).are_passed(&point), !free);
                assert_eq!(Foot::on_axis(&point, &curve, 1.0, ends).is_some(), free);
            }
        }
    }
}
