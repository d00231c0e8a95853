use nalgebra::Vector3;

/// Bounds of p·h at both ends of a parameter range, for the differences h of the Bézier points of an element along the parameter.
///
/// A point p beyond the bounds of one end for all h has its closest point on this end.
#[derive(Debug)]
pub(in crate::contact) struct EndBounds<const K: usize>([(Vector3<f64>, [f64; 2]); K]);

/// Distance from an end, relative to the sum of the radii, beyond which a point has no contact.
pub(in crate::contact) const END_MARGIN: f64 = 0.5;

impl<const K: usize> EndBounds<K> {
    /// Creates the bounds with a margin. `valid` marks the ends that have bounds.
    pub(in crate::contact) fn new(
        points: &[Vector3<f64>],
        differences: [Vector3<f64>; K],
        valid: [bool; 2],
        margin: f64,
    ) -> Self {
        Self(differences.map(|h| {
            let along = || points.iter().map(|point| point.dot(&h));
            let lower = along().fold(f64::INFINITY, f64::min) - margin * h.norm();
            let upper = along().fold(f64::NEG_INFINITY, f64::max) + margin * h.norm();
            let bounds = [
                if valid[0] { lower } else { f64::NEG_INFINITY },
                if valid[1] { upper } else { f64::INFINITY },
            ];
            (h, bounds)
        }))
    }

    /// Returns true if a point is beyond an end.
    pub(in crate::contact) fn are_passed(&self, point: &Vector3<f64>) -> bool {
        self.0.iter().all(|(h, [lower, _])| point.dot(h) < *lower)
            || self.0.iter().all(|(h, [_, upper])| point.dot(h) > *upper)
    }
}
