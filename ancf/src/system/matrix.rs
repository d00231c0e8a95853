use std::sync::Arc;

use super::Pattern;

/// A symmetric sparse matrix: the lower triangle in the order of its pattern.
#[derive(Clone, Debug)]
pub struct SparseMatrix {
    pattern: Arc<Pattern>,
    values: Vec<f64>,
}

impl SparseMatrix {
    pub(super) fn zero(pattern: Arc<Pattern>) -> Self {
        let values = vec![0.0; pattern.entries()];
        Self { pattern, values }
    }

    /// Its pattern.
    pub fn pattern(&self) -> &Arc<Pattern> {
        &self.pattern
    }

    /// The values of the lower triangle.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The values of the lower triangle, to be changed.
    pub fn values_mut(&mut self) -> &mut [f64] {
        &mut self.values
    }

    /// Calls `visit(i, j, value)` for every entry of the lower triangle, in positions.
    pub(super) fn visit(&self, mut visit: impl FnMut(usize, usize, f64)) {
        for (j, range) in self.pattern.columns().windows(2).enumerate() {
            for at in range[0]..range[1] {
                visit(self.pattern.rows()[at], j, self.values[at]);
            }
        }
    }

    /// The entry of an unknown with itself.
    pub fn diagonal_of(&self, unknown: usize) -> f64 {
        self.values[self.pattern.columns()[self.pattern.position(unknown)]]
    }

    /// The entries of Φ_q: multiplier (counted after the coordinates), coordinate, value.
    pub fn constraints(&self) -> impl Iterator<Item = (usize, usize, f64)> {
        let unknown = |at: usize| self.pattern.unknown(at);
        let border = self.pattern.border().iter();
        border.map(move |b| (unknown(b.multiplier), unknown(b.coordinate), self.values[b.slot]))
    }

    /// y = A x, in the order of the unknowns.
    pub fn multiply(&self, x: &[f64], y: &mut [f64]) {
        y.fill(0.0);
        self.visit(|i, j, value| {
            let (i, j) = (self.pattern.unknown(i), self.pattern.unknown(j));
            y[i] += value * x[j];
            if i != j {
                y[j] += value * x[i];
            }
        });
    }

    /// The diagonal, in positions.
    pub(super) fn diagonal(&self) -> impl Iterator<Item = f64> {
        self.pattern.columns()[..self.pattern.size()].iter().map(|&first| self.values[first])
    }

    /// r −= A x, in positions.
    pub(super) fn subtract_product(&self, x: &[f64], r: &mut [f64]) {
        for (j, range) in self.pattern.columns().windows(2).enumerate() {
            let rows = &self.pattern.rows()[range[0] + 1..range[1]];
            let values = &self.values[range[0] + 1..range[1]];
            let mut column = self.values[range[0]] * x[j];
            for (&i, value) in rows.iter().zip(values) {
                r[i] -= value * x[j];
                column += value * x[i];
            }
            r[j] -= column;
        }
    }

    /// A x, in the order of the unknowns.
    pub fn times(&self, x: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; x.len()];
        self.multiply(x, &mut product);
        product
    }

    /// |A| |x|, in the order of the unknowns: ε times this bounds the rounding errors of A x.
    pub fn magnitudes(&self, x: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; x.len()];
        self.visit(|i, j, value| {
            let (i, j) = (self.pattern.unknown(i), self.pattern.unknown(j));
            sums[i] += (value * x[j]).abs();
            if i != j {
                sums[j] += (value * x[i]).abs();
            }
        });
        sums
    }

    /// |x|ᵀ |A| |x|: ε times this bounds the rounding error of xᵀ A x.
    pub fn magnitude(&self, x: &[f64]) -> f64 {
        self.magnitudes(x).iter().zip(x).map(|(sum, x)| sum * x.abs()).sum()
    }

    /// The matrix as dense rows in the order of the unknowns; for small systems and tests.
    pub fn dense(&self) -> Vec<Vec<f64>> {
        let size = self.pattern.size();
        let mut dense = vec![vec![0.0; size]; size];
        self.visit(|i, j, value| {
            let (i, j) = (self.pattern.unknown(i), self.pattern.unknown(j));
            dense[i][j] = value;
            dense[j][i] = value;
        });
        dense
    }
}
