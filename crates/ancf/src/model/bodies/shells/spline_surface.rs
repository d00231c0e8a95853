use nalgebra::{DMatrix, Vector3};

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

/// Knots of a direction with the matrix of the slopes of a spline by its values.
struct Direction {
    knots: Vec<f64>,
    slopes: DMatrix<f64>,
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
        if !is_ascending {
            return None;
        }
        let slopes = slopes(&knots, is_closed)?;
        Some(Self { knots, slopes })
    }

    fn slopes(&self, values: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
        let of = |i: usize| values.iter().enumerate().map(|(j, value)| value * self.slopes[(i, j)]).sum();
        (0..values.len()).map(of).collect()
    }
}

/// Returns the slopes at the knots for unit values at each knot.
fn slopes(x: &[f64], is_closed: bool) -> Option<DMatrix<f64>> {
    let n = x.len();
    let h: Vec<f64> = x.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let (mut a, mut b) = (DMatrix::zeros(n, n), DMatrix::zeros(n, n));
    // Adds a multiple of the mean slope of a span to the right-hand side of a row.
    let add = |b: &mut DMatrix<f64>, row: usize, span: usize, factor: f64| {
        b[(row, span)] -= factor / h[span];
        b[(row, span + 1)] += factor / h[span];
    };
    // Continuous second derivatives between two spans.
    let smooth = |a: &mut DMatrix<f64>, b: &mut DMatrix<f64>, row: usize, [before, after]: [usize; 2]| {
        a[(row, before)] += h[after];
        a[(row, row)] += 2.0 * (h[before] + h[after]);
        a[(row, after + 1)] += h[before];
        add(b, row, before, 3.0 * h[after]);
        add(b, row, after, 3.0 * h[before]);
    };
    (1..n - 1).for_each(|i| smooth(&mut a, &mut b, i, [i - 1, i]));
    let last = n - 1;
    if is_closed {
        smooth(&mut a, &mut b, 0, [last - 1, 0]);
        (a[(last, 0)], a[(last, last)]) = (-1.0, 1.0);
    } else if n < 4 {
        // A line, or a parabola.
        for (row, other, span) in [(0, 1, 0), (last, last - 1, last - 1)] {
            (a[(row, row)], a[(row, other)]) = (1.0, if n == 2 { 0.0 } else { 1.0 });
            add(&mut b, row, span, if n == 2 { 1.0 } else { 2.0 });
        }
    } else {
        for (row, other, [end, next]) in [(0, 1, [0, 1]), (last, last - 1, [last - 1, last - 2])] {
            let both = h[end] + h[next];
            (a[(row, row)], a[(row, other)]) = (h[next], both);
            add(&mut b, row, end, (h[end] + 2.0 * both) * h[next] / both);
            add(&mut b, row, next, h[end] * h[end] / both);
        }
    }
    a.lu().solve(&b)
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
