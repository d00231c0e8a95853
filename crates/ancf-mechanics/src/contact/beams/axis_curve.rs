use nalgebra::Vector3;

use crate::kinematics::ElementAxis;

/// Axis of an element in a state: r = c₀ + c₁ ξ + c₂ ξ² + c₃ ξ³, 0 ≤ ξ ≤ 1, relative to an origin.
#[derive(Clone, Copy, Debug)]
pub(super) struct AxisCurve([Vector3<f64>; 4]);

/// Number of start points in the search for the closest point of an element.
const START_POINTS: usize = 5;
const ITERATIONS: usize = 30;
/// Increment of ξ below which the next increment of Newton's method is a rounding error.
const QUADRATIC: f64 = 1e-9;
/// Part of |r′|² above which |r′|² − d·r″ is the divisor of an iteration. It is Newton's method then.
const CONVEX: f64 = 0.1;

impl AxisCurve {
    /// Evaluates the axis of an element, given the coordinates q.
    pub(super) fn new(axis: &ElementAxis, q: &[f64], origin: &Vector3<f64>) -> Self {
        Self(axis.polynomial(q, origin))
    }

    /// Returns r at ξ.
    pub(super) fn point(&self, xi: f64) -> Vector3<f64> {
        let [a, b, c, d] = &self.0;
        a + (b + (c + d * xi) * xi) * xi
    }

    /// Returns r, dr/dξ and d²r/dξ² at ξ.
    pub(super) fn at(&self, xi: f64) -> [Vector3<f64>; 3] {
        let [_, b, c, d] = &self.0;
        let curvature = c + d * (3.0 * xi);
        [self.point(xi), b + (c + curvature) * xi, curvature * 2.0]
    }

    /// Returns ξ of the closest point: the best of several start points, improved by Newton's method.
    pub(super) fn closest(&self, point: &Vector3<f64>) -> f64 {
        let distance = |k: usize| (point - self.point(at(k))).norm_squared();
        let mut best = (distance(0), 0);
        for k in 1..START_POINTS {
            let here = distance(k);
            if here < best.0 {
                best = (here, k);
            }
        }
        let mut xi = at(best.1);
        for _ in 0..ITERATIONS {
            let [r, slope, curvature] = self.at(xi);
            let (d, square) = (point - r, slope.norm_squared());
            let bent = square - d.dot(&curvature);
            let is_newton = bent > CONVEX * square;
            let next = (xi + d.dot(&slope) / if is_newton { bent } else { square }).clamp(0.0, 1.0);
            let moved = (next - xi).abs();
            xi = next;
            if moved <= if is_newton { QUADRATIC } else { f64::EPSILON } {
                break;
            }
        }
        xi
    }

    /// Returns the Bézier points, whose convex hull contains the curve.
    pub(super) fn bezier_points(&self) -> [Vector3<f64>; 4] {
        let [a, b, c, d] = &self.0;
        let second = a + b / 3.0;
        [*a, second, second + (b + c) / 3.0, a + b + c + d]
    }

    /// Returns the largest |d²r/dξ²|.
    pub(super) fn bending(&self) -> f64 {
        let [_, _, c, d] = &self.0;
        2.0 * c.norm().max((c + d * 3.0).norm())
    }
}

/// Returns ξ of a start point.
fn at(k: usize) -> f64 {
    k as f64 / (START_POINTS - 1) as f64
}

/// Hull of an axis: all points within a distance from the chord.
#[derive(Clone, Copy, Debug)]
pub(super) struct AxisHull {
    start: Vector3<f64>,
    chord: Vector3<f64>,
    /// 1/|chord|², or 0.
    inverse: f64,
    radius: f64,
    /// Upper bound of |dr/dξ|.
    speed: f64,
}

impl AxisHull {
    pub(super) fn new(curve: &AxisCurve) -> Self {
        let [a, b, c, d] = curve.bezier_points();
        let (chord, steps) = (d - a, [b - a, c - b, d - c]);
        let square = chord.norm_squared();
        let inverse = if square > 0.0 { square.recip() } else { 0.0 };
        let speed = 3.0 * steps.iter().map(Vector3::norm_squared).fold(0.0, f64::max).sqrt();
        let line = Self { start: a, chord, inverse, radius: 0.0, speed };
        Self { radius: line.distance(&b).max(line.distance(&c)), ..line }
    }

    /// Returns a lower bound of the distance of a point from the axis. It may be negative.
    pub(super) fn distance(&self, point: &Vector3<f64>) -> f64 {
        let from = point - self.start;
        let part = (from.dot(&self.chord) * self.inverse).clamp(0.0, 1.0);
        (from - self.chord * part).norm() - self.radius
    }

    /// Returns a lower bound of the distance of two axes.
    pub(super) fn distance_from(&self, other: &Self) -> f64 {
        let ends = |hull: &Self| [hull.start, hull.start + hull.chord];
        let of_ends = ends(self).map(|end| other.distance(&end) - self.radius);
        let of_others = ends(other).map(|end| self.distance(&end) - other.radius);
        let least = of_ends.into_iter().chain(of_others).fold(f64::INFINITY, f64::min);
        // Lines that are not parallel are closest where their connection is normal to both.
        let normal = self.chord.cross(&other.chord);
        let square = normal.norm_squared();
        let between = other.start - self.start;
        let parts = [&other.chord, &self.chord].map(|chord| between.cross(chord).dot(&normal) / square);
        if parts.iter().all(|part| (0.0..=1.0).contains(part)) {
            let gap = between.dot(&normal).abs() / square.sqrt();
            return least.min(gap - self.radius - other.radius);
        }
        least
    }

    /// Visits those of `count` equidistant points of the curve of this hull that may be nearer to another axis than a limit.
    ///
    /// `visit` receives the index, the point and the lower bound of its distance. It returns the limit of the next points.
    /// The distance of neighbours is bounded, so points far away are skipped.
    pub(super) fn scan(
        &self,
        (curve, count): (&AxisCurve, usize),
        other: &Self,
        mut limit: f64,
        mut visit: impl FnMut(usize, &Vector3<f64>, f64) -> f64,
    ) {
        let (spacing, mut i) = (self.speed / count as f64, 0);
        while i < count {
            let point = curve.point((i as f64 + 0.5) / count as f64);
            let distance = other.distance(&point);
            if distance > limit {
                i = i.saturating_add(1 + ((distance - limit) / spacing) as usize);
            } else {
                limit = visit(i, &point, distance);
                i += 1;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Linear congruential generator of numbers in [−1, 1).
    fn random(seed: &mut u64) -> f64 {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (*seed >> 32) as f64 / f64::from(1_u32 << 31) - 1.0
    }

    fn curve(seed: &mut u64) -> AxisCurve {
        AxisCurve([1.0, 1.0, 0.4, 0.3].map(|size| Vector3::from_fn(|_, _| size * random(seed))))
    }

    fn samples(curve: &AxisCurve) -> impl Iterator<Item = Vector3<f64>> {
        (0..=100).map(|k| curve.point(f64::from(k) / 100.0))
    }

    /// Distances from hulls are bounds of those from all points of the curves.
    #[test]
    fn hulls_bound_distances() {
        let mut seed = 3;
        for _ in 0..300 {
            let (a, b) = (curve(&mut seed), curve(&mut seed));
            let (of_a, of_b) = (AxisHull::new(&a), AxisHull::new(&b));
            let bound = of_a.distance_from(&of_b);
            assert!((of_b.distance_from(&of_a) - bound).abs() < 1e-12);
            for p in samples(&a) {
                let nearest = samples(&b).map(|q| (p - q).norm()).fold(f64::INFINITY, f64::min);
                assert!(of_b.distance(&p) <= nearest + 1e-12 && bound <= nearest + 1e-12);
            }
        }
    }

    /// A straight curve is its own hull, so bounds are distances: here of crossing, parallel and consecutive axes.
    #[test]
    fn hulls_of_straight_axes_are_exact() {
        let line = |from: [f64; 3], way: [f64; 3]| {
            let zero = Vector3::zeros();
            AxisHull::new(&AxisCurve([from.into(), way.into(), zero, zero]))
        };
        let first = line([0.0; 3], [2.0, 0.0, 0.0]);
        let cases = [
            (line([1.0, -1.0, 0.3], [0.0, 2.0, 0.0]), 0.3),
            (line([0.5, 0.0, 0.7], [1.0, 0.0, 0.0]), 0.7),
            (line([5.0, 4.0, 0.0], [1.0, 0.0, 0.0]), 5.0),
            (line([3.0, -1.0, 0.0], [0.0, 2.0, 0.0]), 1.0),
        ];
        for (other, distance) in cases {
            assert!((first.distance_from(&other) - distance).abs() < 1e-12, "{distance}");
        }
    }

    /// Points that are skipped are farther away than the limit.
    #[test]
    fn scans_skip_far_points_only() {
        let (mut seed, mut visited) = (11, 0);
        for _ in 0..300 {
            let (a, b) = (curve(&mut seed), curve(&mut seed));
            let (of_a, of_b, count, limit) = (AxisHull::new(&a), AxisHull::new(&b), 40, 0.2);
            let mut found = Vec::new();
            of_a.scan((&a, count), &of_b, limit, |i, _, _| {
                found.push(i);
                limit
            });
            visited += found.len();
            let near = |i: &usize| of_b.distance(&a.point((*i as f64 + 0.5) / count as f64)) <= limit;
            assert_eq!(found, (0..count).filter(near).collect::<Vec<_>>());
        }
        assert!(visited > 300 && visited < 300 * 20, "{visited}");
    }

    /// Closest points are stationary, or at an end.
    #[test]
    fn closest_points_are_stationary() {
        let mut seed = 17;
        for _ in 0..300 {
            let (a, p) = (curve(&mut seed), Vector3::from_fn(|_, _| random(&mut seed)));
            let xi = a.closest(&p);
            let [r, slope, _] = a.at(xi);
            let along = (p - r).dot(&slope) / (slope.norm_squared() + (p - r).norm_squared());
            let is_stationary =
                along.abs() < 1e-12 || (xi == 0.0 && along < 0.0) || (xi == 1.0 && along > 0.0);
            assert!(is_stationary, "{xi}, {along}");
        }
    }
}
