use nalgebra::Vector3;

use super::bicubic_surface::BicubicSurface;
use crate::contact::parts::{END_MARGIN, EndBounds, NODE_TRANSITION};

/// Planes at the edges of an element. A point beyond one of them has no contact with the element, but with a neighbour.
///
/// If d·r_ξ < 0 for all ξ and η, the distance |d| from a point increases with ξ. The closest point is then on the edge ξ = 0, on
/// which the element has no share. This is the case if (p − b)·h < 0 for all Bézier points b and their differences h along ξ.
/// Neighbours thus have no terms unless the surface is folded. A thickness that varies moves the closest point: there are no planes.
#[derive(Debug)]
pub(super) struct EdgePlanes([EndBounds<12>; 2]);

impl EdgePlanes {
    /// Creates the planes for points within a distance of an element. `free` marks the free edges along ξ and along η.
    pub(super) fn new(surface: &BicubicSurface, free: [[bool; 2]; 2], distance: f64) -> Self {
        let (points, margin) = (surface.points(), END_MARGIN * distance);
        let along_x = std::array::from_fn(|k| points[k / 3][k % 3 + 1] - points[k / 3][k % 3]);
        let along_y = std::array::from_fn(|k| points[k % 3 + 1][k / 3] - points[k % 3][k / 3]);
        let bounds = |differences: [Vector3<f64>; 12], free: [bool; 2]| {
            // The margin exceeds the transition at the edge.
            let is_far = differences.iter().all(|h| margin > 12.0 * NODE_TRANSITION * h.norm());
            let valid = free.map(|free| !free && is_far && !surface.has_excess());
            EndBounds::new(points.as_flattened(), differences, valid, margin)
        };
        Self([bounds(along_x, free[0]), bounds(along_y, free[1])])
    }

    /// Returns true if a point is beyond an edge where the surface continues.
    pub(super) fn are_passed(&self, point: &Vector3<f64>) -> bool {
        self.0.iter().any(|bounds| bounds.are_passed(point))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::parts::Foot;
    use crate::shells::{ElementSurface, VECTORS};

    /// An element has no share in the contact of points beyond its planes, at any curvature.
    #[test]
    fn points_beyond_have_no_contact() {
        let (mut seed, mut passed, mut kept) = (29_u64, 0, 0);
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 32) as f64 / f64::from(1_u32 << 31) - 1.0
        };
        for case in 0..6000 {
            let mut vector = |size: f64| Vector3::from_fn(|_, _| size * random());
            let flat = |a: usize| match a % 4 {
                0 => Vector3::new((a / 4 % 2) as f64, (a / 8) as f64, 0.0),
                1 => Vector3::x(),
                2 => Vector3::y(),
                _ => Vector3::zeros(),
            };
            let values: [Vector3<f64>; VECTORS] = std::array::from_fn(|a| flat(a) + vector(0.05));
            let element = ElementSurface::new(std::array::from_fn(|a| 3 * a), values);
            let surface = BicubicSurface::new(&element, None, &[0.0; 3 * VECTORS], &Vector3::zeros());
            let middle = Vector3::new(f64::from(case % 3) * 0.5, f64::from(case / 3 % 3) * 0.5, 0.0);
            let (point, distance) = (vector(0.3) + middle, 0.2);
            let near = (point - surface.point(surface.closest(&point))).norm() < distance;
            let foot = Foot::on_surface(&point, &surface, [[false; 2]; 2]);
            if EdgePlanes::new(&surface, [[false; 2]; 2], distance).are_passed(&point) {
                passed += usize::from(near);
                assert!(!near || foot.is_none());
            } else {
                kept += usize::from(near && foot.is_some());
            }
        }
        assert!(passed > 20 && kept > 20, "{passed}, {kept}");
    }
}
