use ancf_mechanics::kinematics::{TridiagonalRow, solve_cyclic_tridiagonal, solve_tridiagonal};
use nalgebra::Vector3;

/// Surface through a grid of points: a cubic spline along each of two directions, twice continuously differentiable.
///
/// Parameters 0 ≤ u, v ≤ 1 are the lengths of the chords, averaged over the rows and over the columns. Third derivatives are continuous at
/// the last knot before an end (not a knot). Two points are joined by a line, three by a parabola. A direction whose first and
/// last points coincide is periodic.
///
/// Source: de Boor (1978), tensor products of splines.
#[derive(Clone, Debug)]
pub(crate) struct SplineSurface {
    knots: [Vec<f64>; 2],
    /// Values r, ∂r/∂u, ∂r/∂v and ∂²r/∂u∂v at the points, along u first.
    points: Vec<[Vector3<f64>; 4]>,
}

impl SplineSurface {
    /// Creates the surface through rows of points: rows along v, the points of a row along u.
    ///
    /// `None` for fewer than two rows or points, rows of different lengths, or equal parameters of neighbours.
    pub(crate) fn new(rows: &[Vec<Vector3<f64>>]) -> Option<Self> {
        let (n, m) = (rows.first()?.len(), rows.len());
        if n < 2 || m < 2 || rows.iter().any(|row| row.len() != n) {
            return None;
        }
        let columns: Vec<Vec<_>> = (0..n).map(|i| rows.iter().map(|row| row[i]).collect()).collect();
        let along_u = Direction::new(rows)?;
        let along_v = Direction::new(&columns)?;
        let mut points = vec![[Vector3::zeros(); 4]; n * m];
        for (j, row) in rows.iter().enumerate() {
            let slopes = along_u.slopes(row);
            for (i, (point, slope)) in row.iter().zip(slopes).enumerate() {
                (points[j * n + i][0], points[j * n + i][1]) = (*point, slope);
            }
        }
        for i in 0..n {
            for kind in [0, 1] {
                let column: Vec<_> = (0..m).map(|j| points[j * n + i][kind]).collect();
                for (j, slope) in along_v.slopes(&column).into_iter().enumerate() {
                    points[j * n + i][kind + 2] = slope;
                }
            }
        }
        Some(Self { knots: [along_u.knots, along_v.knots], points })
    }

    /// Returns r, ∂r/∂u, ∂r/∂v and ∂²r/∂u∂v at (u, v).
    pub(crate) fn at(&self, at: [f64; 2]) -> [Vector3<f64>; 4] {
        let [u, v] = [0, 1].map(|k| Span::new(&self.knots[k], at[k]));
        let n = self.knots[0].len();
        let mut sums = [Vector3::zeros(); 4];
        for (a, b) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let values = &self.points[(v.first + b) * n + u.first + a];
            for (kind, value) in values.iter().enumerate() {
                let (k, l) = (2 * a + kind % 2, 2 * b + kind / 2);
                for (order, sum) in sums.iter_mut().enumerate() {
                    *sum += value * (u.hermite[order % 2][k] * v.hermite[order / 2][l]);
                }
            }
        }
        sums
    }
}

/// Knots of a direction.
struct Direction {
    knots: Vec<f64>,
    is_closed: bool,
}

impl Direction {
    /// Creates the common knots of several curves.
    fn new(curves: &[Vec<Vector3<f64>>]) -> Option<Self> {
        let (mut knots, mut total) = (vec![0.0; curves[0].len()], 0.0);
        for curve in curves {
            let mut length = 0.0;
            for (knot, pair) in knots[1..].iter_mut().zip(curve.windows(2)) {
                length += (pair[1] - pair[0]).norm();
                *knot += length;
            }
            total += length;
        }
        knots.iter_mut().for_each(|knot| *knot /= total);
        let is_ascending = knots.windows(2).all(|pair| pair[1] - pair[0] > 1e-9);
        let size = total / curves.len() as f64;
        let is_closed = knots.len() > 3
            && curves.iter().all(|curve| (curve[0] - curve[curve.len() - 1]).norm() < 1e-9 * size);
        is_ascending.then_some(Self { knots, is_closed })
    }

    /// Slopes of the spline at the knots.
    fn slopes(&self, values: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
        let h: Vec<f64> = self.knots.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let means: Vec<_> = values.windows(2).zip(&h).map(|(pair, h)| (pair[1] - pair[0]) / *h).collect();
        // Continuous second derivatives between two spans.
        let smooth = |[before, after]: [usize; 2]| TridiagonalRow {
            lower: h[after],
            diagonal: 2.0 * (h[before] + h[after]),
            upper: h[before],
            right: 3.0 * (means[before] * h[after] + means[after] * h[before]),
        };
        let last = values.len() - 1;
        let inner = (1..last).map(|i| smooth([i - 1, i]));
        if self.is_closed {
            let mut slopes =
                solve_cyclic_tridiagonal(std::iter::once(smooth([last - 1, 0])).chain(inner).collect());
            slopes.push(slopes[0]);
            return slopes;
        }
        // A line, a parabola, or a continuous third derivative.
        let end = |end: usize, next: usize| match values.len() {
            2 => [1.0, 0.0, 1.0, 0.0],
            3 => [1.0, 1.0, 2.0, 0.0],
            _ => {
                let both = h[end] + h[next];
                [h[next], both, (h[end] + 2.0 * both) * h[next] / both, h[end] * h[end] / both]
            }
        };
        let [next, before] = [1.min(last - 1), last.saturating_sub(2)];
        let [diagonal, upper, own, other] = end(0, next);
        let first =
            TridiagonalRow { lower: 0.0, diagonal, upper, right: means[0] * own + means[next] * other };
        let [diagonal, lower, own, other] = end(last - 1, before);
        let right = means[last - 1] * own + means[before] * other;
        let rows = std::iter::once(first).chain(inner);
        solve_tridiagonal(rows.chain([TridiagonalRow { lower, diagonal, upper: 0.0, right }]).collect())
    }
}

/// Span of a parameter, with the values and derivatives of Hermite's functions of its ends (value, slope; value, slope).
struct Span {
    first: usize,
    hermite: [[f64; 4]; 2],
}

impl Span {
    fn new(knots: &[f64], x: f64) -> Self {
        let first = knots[1..knots.len() - 1].partition_point(|knot| *knot <= x);
        let h = knots[first + 1] - knots[first];
        let t = (x - knots[first]) / h;
        let values = [
            (1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t),
            h * t * (1.0 - t) * (1.0 - t),
            t * t * (3.0 - 2.0 * t),
            h * t * t * (t - 1.0),
        ];
        let rates = [
            6.0 * t * (t - 1.0) / h,
            (1.0 - t) * (1.0 - 3.0 * t),
            6.0 * t * (1.0 - t) / h,
            t * (3.0 * t - 2.0),
        ];
        Self { first, hermite: [values, rates] }
    }
}
