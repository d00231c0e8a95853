use crate::sparse::SparseMatrix;

/// Symmetric matrix with all its nonzero entries by rows, for many products.
#[derive(Clone, Debug)]
pub(super) struct FullRows {
    /// End of each row in `entries`.
    ends: Vec<usize>,
    entries: Vec<(u32, f64)>,
    diagonal: Vec<f64>,
}

impl FullRows {
    pub(super) fn new(matrix: &SparseMatrix) -> Self {
        let pattern = matrix.pattern();
        let size = pattern.size();
        let mut lower = Vec::new();
        matrix.visit(|i, j, value| {
            if value != 0.0 {
                lower.push((pattern.unknown(i), pattern.unknown(j), value));
            }
        });
        let mut ends = vec![0; size + 1];
        for &(i, j, _) in &lower {
            ends[i + 1] += 1;
            ends[j + 1] += usize::from(i != j);
        }
        (0..size).for_each(|i| ends[i + 1] += ends[i]);
        let mut entries = vec![(0, 0.0); ends[size]];
        let mut put = |i: usize, j: usize, value: f64| {
            entries[ends[i]] = (j as u32, value);
            ends[i] += 1;
        };
        let mut diagonal = vec![0.0; size];
        for &(i, j, value) in &lower {
            put(i, j, value);
            if i == j {
                diagonal[i] = value;
            } else {
                put(j, i, value);
            }
        }
        ends.truncate(size);
        Self { ends, entries, diagonal }
    }

    pub(super) fn diagonal(&self) -> &[f64] {
        &self.diagonal
    }

    /// Computes A x.
    pub(super) fn multiply(&self, x: &[f64], product: &mut [f64]) {
        self.sum_rows(product, |j, value| value * x[j]);
    }

    /// Returns A x.
    pub(super) fn times(&self, x: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; x.len()];
        self.multiply(x, &mut product);
        product
    }

    /// Returns xᵀ A x.
    pub(super) fn square(&self, x: &[f64]) -> f64 {
        self.times(x).iter().zip(x).map(|(product, x)| product * x).sum()
    }

    /// Returns |x|ᵀ |A| |x|. ε times this bounds the rounding error of xᵀ A x.
    pub(super) fn magnitude(&self, x: &[f64]) -> f64 {
        self.magnitudes(x).iter().zip(x).map(|(sum, x)| sum * x.abs()).sum()
    }

    /// Returns |A| |x|.
    pub(super) fn magnitudes(&self, x: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; x.len()];
        self.sum_rows(&mut sums, |j, value| (value * x[j]).abs());
        sums
    }

    fn sum_rows(&self, sums: &mut [f64], of: impl Fn(usize, f64) -> f64) {
        let mut start = 0;
        for (sum, &end) in sums.iter_mut().zip(&self.ends) {
            *sum = self.entries[start..end].iter().map(|&(j, value)| of(j as usize, value)).sum();
            start = end;
        }
    }
}
