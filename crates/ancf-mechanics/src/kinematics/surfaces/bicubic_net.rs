use std::ops::{Add, Div, Mul, Sub};

/// Bicubic polynomial over an element by its Bézier points: Σ Bᵢ(ξ) Bⱼ(η) bᵢⱼ with the cubic Bernstein polynomials.
///
/// Its values are in the convex hull of the points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BicubicNet<T> {
    /// Bézier points, along ξ first.
    pub(crate) points: [[T; 4]; 4],
}

/// Number of values at the four nodes of an element.
const NODAL: usize = 16;

impl<T: Copy + Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T> + Div<f64, Output = T>>
    BicubicNet<T>
{
    /// Creates the polynomial from x, x_ξ, x_η and x_ξη at the nodes of an element.
    pub(crate) fn from_nodes(values: &[T; NODAL]) -> Self {
        // Bézier points of a cubic with the values and slopes at both ends.
        let cubic = |[a, from, b, to]: [T; 4]| [a, a + from / 3.0, b - to / 3.0, b];
        let row = |node: usize, kind: usize| cubic([0, 1, 4, 5].map(|k| values[4 * node + kind + k]));
        let rows = [row(0, 0), row(0, 2), row(2, 0), row(2, 2)];
        let columns: [[T; 4]; 4] = std::array::from_fn(|i| cubic(rows.map(|row| row[i])));
        Self { points: std::array::from_fn(|j| std::array::from_fn(|i| columns[i][j])) }
    }

    /// Returns the value at (ξ, η).
    pub(crate) fn value(&self, [x, y]: [f64; 2]) -> T {
        let ([along, ..], [across, ..]) = (bernstein(x), bernstein(y));
        self.sum(&along, &across)
    }

    /// Returns the value x and x_ξ, x_η, x_ξξ, x_ηη and x_ξη at (ξ, η).
    pub(crate) fn at(&self, [x, y]: [f64; 2]) -> [T; 6] {
        let (along, across) = (bernstein(x), bernstein(y));
        [[0, 0], [1, 0], [0, 1], [2, 0], [0, 2], [1, 1]].map(|[i, j]| self.sum(&along[i], &across[j]))
    }

    fn sum(&self, along: &[f64; 4], across: &[f64; 4]) -> T {
        let of = |row: &[T; 4]| row[0] * along[0] + row[1] * along[1] + row[2] * along[2] + row[3] * along[3];
        let [a, b, c, d] = self.points.each_ref().map(of);
        a * across[0] + b * across[1] + c * across[2] + d * across[3]
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
