use std::ops::Range;

use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, MatRef, Par};
use nalgebra::{DMatrix, DVector};

/// Vectors of equal length, stored one after the other for products by blocks.
#[derive(Clone, Debug)]
pub(super) struct Columns {
    rows: usize,
    entries: Vec<f64>,
}

fn view(matrix: &DMatrix<f64>) -> MatRef<'_, f64> {
    MatRef::from_column_major_slice(matrix.as_slice(), matrix.nrows(), matrix.ncols())
}

impl Columns {
    /// Creates an empty block of vectors with a length.
    pub(super) fn new(rows: usize) -> Self {
        Self { rows, entries: Vec::new() }
    }

    /// Copies vectors.
    pub(super) fn of(rows: usize, vectors: &[DVector<f64>]) -> Self {
        let mut columns = Self::new(rows);
        vectors.iter().for_each(|x| columns.push(x.as_slice()));
        columns
    }

    /// Length of the vectors.
    pub(super) fn rows(&self) -> usize {
        self.rows
    }

    /// Number of vectors.
    pub(super) fn count(&self) -> usize {
        self.entries.len() / self.rows.max(1)
    }

    pub(super) fn push(&mut self, x: &[f64]) {
        self.entries.extend_from_slice(x);
    }

    pub(super) fn column(&self, k: usize) -> &[f64] {
        &self.entries[k * self.rows..(k + 1) * self.rows]
    }

    pub(super) fn column_mut(&mut self, k: usize) -> &mut [f64] {
        &mut self.entries[k * self.rows..(k + 1) * self.rows]
    }

    fn as_matrix(&self) -> MatRef<'_, f64> {
        MatRef::from_column_major_slice(&self.entries, self.rows, self.count())
    }

    /// Computes Xᵀ Y.
    pub(super) fn products(&self, other: &Self) -> DMatrix<f64> {
        let mut products = DMatrix::zeros(self.count(), other.count());
        let (rows, columns) = products.shape();
        let target = MatMut::from_column_major_slice_mut(products.as_mut_slice(), rows, columns);
        matmul(target, Accum::Replace, self.as_matrix().transpose(), other.as_matrix(), 1.0, Par::Seq);
        products
    }

    /// Adds a multiple of X W, with a column of W for each vector.
    pub(super) fn add(&mut self, other: &Self, weights: &DMatrix<f64>, factor: f64) {
        let (rows, count) = (self.rows, self.count());
        let target = MatMut::from_column_major_slice_mut(&mut self.entries, rows, count);
        matmul(target, Accum::Add, other.as_matrix(), view(weights), factor, Par::Seq);
    }

    /// Computes the linear combinations X W of the first vectors, as many as W has rows.
    pub(super) fn combined(&self, weights: &DMatrix<f64>) -> Self {
        let mut sum = Self { rows: self.rows, entries: vec![0.0; self.rows * weights.ncols()] };
        let first = self.as_matrix().subcols(0, weights.nrows());
        let target = MatMut::from_column_major_slice_mut(&mut sum.entries, self.rows, weights.ncols());
        matmul(target, Accum::Replace, first, view(weights), 1.0, Par::Seq);
        sum
    }

    /// Returns the vectors one by one.
    pub(super) fn vectors(&self) -> Vec<DVector<f64>> {
        self.range(0..self.count())
    }

    /// Returns some vectors one by one.
    pub(super) fn range(&self, range: Range<usize>) -> Vec<DVector<f64>> {
        range.map(|k| DVector::from_column_slice(self.column(k))).collect()
    }
}
