use std::sync::Arc;

use nalgebra::Vector3;

use super::target::TargetSurface;
use crate::kinematics::{
    BicubicNet, SurfaceSlopes, SurfaceValues, closest_offset_point, closest_point, gap_slopes,
};
use crate::shells::ElementSurface;

/// Surface of an element in a state, relative to an origin, and its radius, half the thickness.
#[derive(Clone, Debug)]
pub struct BicubicSurface {
    net: BicubicNet<Vector3<f64>>,
    /// Radius less the smallest one, if it varies.
    excess: Option<Arc<BicubicNet<f64>>>,
}

impl BicubicSurface {
    /// Evaluates the surface of an element, given the coordinates q.
    pub(super) fn new(
        surface: &ElementSurface,
        excess: Option<&Arc<BicubicNet<f64>>>,
        q: &[f64],
        origin: &Vector3<f64>,
    ) -> Self {
        Self { net: BicubicNet::from_nodes(&surface.values(q, origin)), excess: excess.cloned() }
    }

    /// Returns the Bézier points, along ξ first.
    pub(super) const fn points(&self) -> &[[Vector3<f64>; 4]; 4] {
        &self.net.points
    }

    /// Returns true if the radius varies.
    pub(super) const fn has_excess(&self) -> bool {
        self.excess.is_some()
    }

    /// Returns r at (ξ, η).
    pub(super) fn point(&self, at: [f64; 2]) -> Vector3<f64> {
        self.net.value(at)
    }

    /// Returns r and its derivatives at (ξ, η).
    pub(super) fn at(&self, at: [f64; 2]) -> SurfaceValues {
        self.net.at(at)
    }

    /// Returns (ξ, η) of the closest point: that of the nearest Bézier point, improved by Newton's method with line search.
    pub(super) fn closest(&self, point: &Vector3<f64>) -> [f64; 2] {
        let start = self.start(point);
        match &self.excess {
            None => closest_point(point, start, |at| self.at(at)),
            Some(excess) => closest_offset_point(point, start, |at| (self.at(at), excess.at(at))),
        }
    }

    /// Returns the radius less the smallest one at (ξ, η).
    pub(super) fn excess_at(&self, at: [f64; 2]) -> f64 {
        self.excess.as_ref().map_or(0.0, |excess| excess.value(at))
    }

    /// Returns the derivatives of the distance at (ξ, η) for a vector d from there, and the parts of r_ξ and r_η along which the gap has
    /// no derivative.
    pub(super) fn slopes(
        &self,
        d: &Vector3<f64>,
        values: &SurfaceValues,
        at: [f64; 2],
    ) -> (SurfaceSlopes, [Vector3<f64>; 2]) {
        gap_slopes(d, values, self.excess.as_ref().map(|excess| excess.at(at)))
    }

    /// Returns (ξ, η) of the nearest Bézier point, as on a plane parallelogram.
    fn start(&self, point: &Vector3<f64>) -> [f64; 2] {
        let places = (0..4).flat_map(|j| (0..4).map(move |i| (i, j)));
        let distance = |(i, j): (usize, usize)| (point - self.points()[j][i]).norm_squared();
        let nearest = places.min_by(|a, b| distance(*a).total_cmp(&distance(*b)));
        nearest.map_or([0.0; 2], |(i, j)| [i as f64 / 3.0, j as f64 / 3.0])
    }
}

impl TargetSurface for BicubicSurface {
    fn hull_points(&self) -> &[Vector3<f64>] {
        self.points().as_flattened()
    }

    fn largest_excess(&self) -> f64 {
        let points = self.excess.iter().flat_map(|excess| excess.points.as_flattened());
        points.copied().fold(0.0, f64::max)
    }

    fn between(&self, to: &Self, part: f64) -> Self {
        let (own, other) = (self.points(), to.points());
        let at = |i: usize, j: usize| own[j][i] + (other[j][i] - own[j][i]) * part;
        let net = BicubicNet { points: std::array::from_fn(|j| std::array::from_fn(|i| at(i, j))) };
        Self { net, excess: self.excess.clone() }
    }

    fn relative_distance(&self, point: &Vector3<f64>, radius: f64) -> f64 {
        let at = self.closest(point);
        (point - self.point(at)).norm() / (radius + self.excess_at(at))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shells::VECTORS;

    /// Linear congruential generator of numbers in [−1, 1).
    fn random(seed: &mut u64) -> f64 {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (*seed >> 32) as f64 / f64::from(1_u32 << 31) - 1.0
    }

    /// Unit square with random deviations of the nodal vectors.
    fn surface(seed: &mut u64, size: f64) -> ElementSurface {
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
        let vectors = std::array::from_fn(|a| {
            let flat = match a % 4 {
                0 => Vector3::new(corners[a / 4][0], corners[a / 4][1], 0.0),
                1 => Vector3::x(),
                2 => Vector3::y(),
                _ => Vector3::zeros(),
            };
            flat + Vector3::from_fn(|_, _| size * random(seed))
        });
        ElementSurface::new(std::array::from_fn(|a| 3 * a), vectors)
    }

    /// The Bézier form has the values and derivatives of the Hermite form.
    #[test]
    fn bezier_form_equals_the_hermite_form() {
        let (mut seed, q) = (5, [0.0; 3 * VECTORS]);
        let element = surface(&mut seed, 0.3);
        let (form, values) = (
            BicubicSurface::new(&element, None, &q, &Vector3::zeros()),
            element.values(&q, &Vector3::zeros()),
        );
        for at in [[0.0, 0.0], [1.0, 0.3], [0.2, 0.7]] {
            let found = form.at(at);
            for (k, weights) in ElementSurface::weights(at).iter().enumerate() {
                let expected: Vector3<f64> = values.iter().zip(weights).map(|(x, w)| x * *w).sum();
                assert!((found[k] - expected).norm() < 1e-14);
            }
            let h = 1e-5;
            let slopes = |k: usize, sign: f64| {
                let mut moved = at;
                moved[k] += sign * h;
                form.at(moved)
            };
            for (second, k, first) in [(3, 0, 1), (4, 1, 2), (5, 1, 1)] {
                let difference = (slopes(k, 1.0)[first] - slopes(k, -1.0)[first]) / (2.0 * h);
                assert!((found[second] - difference).norm() < 1e-9);
            }
        }
    }

    /// Closest points are nearer than all points of a grid, and stationary along parameters that are not at a bound.
    #[test]
    fn closest_points_are_closest() {
        let (mut seed, q, mut inside) = (17, [0.0; 3 * VECTORS], 0);
        for _ in 0..300 {
            let form = BicubicSurface::new(&surface(&mut seed, 0.1), None, &q, &Vector3::zeros());
            let p = Vector3::new(0.5, 0.5, 0.0)
                + Vector3::new(random(&mut seed), random(&mut seed), 0.3 * random(&mut seed));
            let at = form.closest(&p);
            let (d, grid) = (p - form.point(at), 0..=20);
            let places =
                grid.clone().flat_map(|i| grid.clone().map(move |j| [i, j].map(|k| f64::from(k) / 20.0)));
            let nearest = places.map(|at| (p - form.point(at)).norm()).fold(f64::INFINITY, f64::min);
            assert!(d.norm() <= nearest + 1e-12, "{at:?}: {} > {nearest}", d.norm());
            let ((gradient, ..), _) = gap_slopes(&d, &form.at(at), None);
            let is_inner = at.map(|x| x > 0.0 && x < 1.0);
            assert!((0..2).all(|k| !is_inner[k] || gradient[k].abs() < 1e-9), "{at:?}: {gradient}");
            inside += usize::from(is_inner == [true; 2]);
        }
        assert!(inside > 50, "{inside}");
    }
}
