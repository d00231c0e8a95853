use nalgebra::Vector3;

use super::target::TargetSurface;
use crate::kinematics::{SurfaceValues, closest_point};
use crate::shells::ElementSurface;

/// Surface of an element in a state: r = Σ Bᵢ(ξ) Bⱼ(η) bᵢⱼ with the cubic Bernstein polynomials, relative to an origin.
///
/// The surface is in the convex hull of the Bézier points bᵢⱼ.
#[derive(Clone, Copy, Debug)]
pub struct BicubicSurface {
    /// Bézier points, along ξ first.
    pub(super) points: [[Vector3<f64>; 4]; 4],
}

impl BicubicSurface {
    /// Evaluates the surface of an element, given the coordinates q.
    pub(super) fn new(surface: &ElementSurface, q: &[f64], origin: &Vector3<f64>) -> Self {
        let values = surface.values(q, origin);
        // Bézier points of a cubic with the values and slopes at both ends.
        let cubic = |[a, from, b, to]: [Vector3<f64>; 4]| [a, a + from / 3.0, b - to / 3.0, b];
        let row = |node: usize, kind: usize| cubic([0, 1, 4, 5].map(|k| values[4 * node + kind + k]));
        let rows = [row(0, 0), row(0, 2), row(2, 0), row(2, 2)];
        let columns: [[Vector3<f64>; 4]; 4] = std::array::from_fn(|i| cubic(rows.map(|row| row[i])));
        Self { points: std::array::from_fn(|j| std::array::from_fn(|i| columns[i][j])) }
    }

    /// Returns r at (ξ, η).
    pub(super) fn point(&self, [x, y]: [f64; 2]) -> Vector3<f64> {
        let ([along, ..], [across, ..]) = (bernstein(x), bernstein(y));
        self.sum(&along, &across)
    }

    fn sum(&self, along: &[f64; 4], across: &[f64; 4]) -> Vector3<f64> {
        let mut sum = Vector3::zeros();
        for (row, weight) in self.points.iter().zip(across) {
            let of_row = row[0] * along[0] + row[1] * along[1] + row[2] * along[2] + row[3] * along[3];
            sum += of_row * *weight;
        }
        sum
    }

    /// Returns r and its derivatives at (ξ, η).
    pub(super) fn at(&self, [x, y]: [f64; 2]) -> SurfaceValues {
        let (along, across) = (bernstein(x), bernstein(y));
        [[0, 0], [1, 0], [0, 1], [2, 0], [0, 2], [1, 1]].map(|[i, j]| self.sum(&along[i], &across[j]))
    }

    /// Returns (ξ, η) of the closest point: that of the nearest Bézier point, improved by Newton's method with line search.
    pub(super) fn closest(&self, point: &Vector3<f64>) -> [f64; 2] {
        closest_point(point, self.start(point), |at| self.at(at))
    }

    /// Returns (ξ, η) of the nearest Bézier point, as on a plane parallelogram.
    fn start(&self, point: &Vector3<f64>) -> [f64; 2] {
        let places = (0..4).flat_map(|j| (0..4).map(move |i| (i, j)));
        let distance = |(i, j): (usize, usize)| (point - self.points[j][i]).norm_squared();
        let nearest = places.min_by(|a, b| distance(*a).total_cmp(&distance(*b)));
        nearest.map_or([0.0; 2], |(i, j)| [i as f64 / 3.0, j as f64 / 3.0])
    }
}

impl TargetSurface for BicubicSurface {
    fn hull_points(&self) -> &[Vector3<f64>] {
        self.points.as_flattened()
    }

    fn between(&self, to: &Self, part: f64) -> Self {
        let at = |i: usize, j: usize| self.points[j][i] + (to.points[j][i] - self.points[j][i]) * part;
        Self { points: std::array::from_fn(|j| std::array::from_fn(|i| at(i, j))) }
    }

    fn distance(&self, point: &Vector3<f64>) -> f64 {
        (point - self.point(self.closest(point))).norm()
    }
}

/// Returns the cubic Bernstein polynomials and their two derivatives.
fn bernstein(x: f64) -> [[f64; 4]; 3] {
    let y = 1.0 - x;
    [
        [y * y * y, 3.0 * x * y * y, 3.0 * x * x * y, x * x * x],
        [-3.0 * y * y, 3.0 * y * (y - 2.0 * x), 3.0 * x * (2.0 * y - x), 3.0 * x * x],
        [6.0 * y, 6.0 * (x - 2.0 * y), 6.0 * (y - 2.0 * x), 6.0 * x],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kinematics::derivatives;
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
        let (form, values) =
            (BicubicSurface::new(&element, &q, &Vector3::zeros()), element.values(&q, &Vector3::zeros()));
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
            let form = BicubicSurface::new(&surface(&mut seed, 0.1), &q, &Vector3::zeros());
            let p = Vector3::new(0.5, 0.5, 0.0)
                + Vector3::new(random(&mut seed), random(&mut seed), 0.3 * random(&mut seed));
            let at = form.closest(&p);
            let (d, grid) = (p - form.point(at), 0..=20);
            let places =
                grid.clone().flat_map(|i| grid.clone().map(move |j| [i, j].map(|k| f64::from(k) / 20.0)));
            let nearest = places.map(|at| (p - form.point(at)).norm()).fold(f64::INFINITY, f64::min);
            assert!(d.norm() <= nearest + 1e-12, "{at:?}: {} > {nearest}", d.norm());
            let (gradient, _, _) = derivatives(&d, &form.at(at));
            let is_inner = at.map(|x| x > 0.0 && x < 1.0);
            assert!((0..2).all(|k| !is_inner[k] || gradient[k].abs() < 1e-9), "{at:?}: {gradient}");
            inside += usize::from(is_inner == [true; 2]);
        }
        assert!(inside > 50, "{inside}");
    }
}
