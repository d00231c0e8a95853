use std::ops::Range;
use std::sync::Arc;

use super::pattern::Pattern;
use super::supernodes::{QUAD, RowRun, Supernode};

/// Symmetric sparse matrix: the lower triangle in the supernodes of its pattern.
#[derive(Clone, Debug)]
pub struct SparseMatrix {
    pattern: Arc<Pattern>,
    values: Vec<f64>,
    /// False for a stiffness matrix of statics.
    has_inertia: bool,
}

impl SparseMatrix {
    pub(crate) fn zero(pattern: Arc<Pattern>) -> Self {
        let values = vec![0.0; pattern.entries()];
        Self { pattern, values, has_inertia: true }
    }

    /// States if the matrix contains inertia.
    pub(crate) fn set_inertia(&mut self, has_inertia: bool) {
        self.has_inertia = has_inertia;
    }

    /// Returns false for a stiffness matrix of statics.
    pub(crate) fn has_inertia(&self) -> bool {
        self.has_inertia
    }

    /// Returns the pattern.
    pub fn pattern(&self) -> &Arc<Pattern> {
        &self.pattern
    }

    /// Returns the values of the lower triangle, including the padding of the supernodes.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Returns the mutable values of the lower triangle.
    pub fn values_mut(&mut self) -> &mut [f64] {
        &mut self.values
    }

    /// Calls `visit(i, j, value)` for every entry of the lower triangle by position, including the padding.
    pub(crate) fn visit(&self, mut visit: impl FnMut(usize, usize, f64)) {
        let supernodes = self.pattern.supernodes();
        for (at, supernode) in supernodes.list.iter().enumerate() {
            let (shape, values) = (supernode.shape(), &self.values[supernode.values()]);
            for (column, j) in supernode.own().enumerate() {
                let own = shape.at(column, column);
                supernode.own().skip(column).zip(&values[own..]).for_each(|(i, &value)| visit(i, j, value));
                let below = supernodes.runs(at).iter().flat_map(RowRun::positions);
                below
                    .zip(&values[shape.at(QUAD * shape.own(), column)..])
                    .for_each(|(i, &value)| visit(i, j, value));
            }
        }
    }

    /// Calls `visit(j, rows, values)` for parts of the columns of the lower triangle, including the padding.
    ///
    /// Columns and rows are unknowns. The first part of a column begins with the diagonal.
    fn visit_columns(&self, mut visit: impl FnMut(usize, &[u32], &[f64])) {
        let (supernodes, order) = (self.pattern.supernodes(), self.pattern.order());
        for (at, supernode) in supernodes.list.iter().enumerate() {
            let (shape, values) = (supernode.shape(), &self.values[supernode.values()]);
            for (column, j) in supernode.own().enumerate() {
                let mut part = |positions: Range<usize>, from: usize| {
                    let length = positions.len();
                    visit(order[j] as usize, &order[positions], &values[from..from + length]);
                };
                part(j..supernode.own().end, shape.at(column, column));
                let mut from = shape.at(QUAD * shape.own(), column);
                for run in supernodes.runs(at) {
                    part(run.positions(), from);
                    from += run.positions().len();
                }
            }
        }
    }

    /// Multiplies the rows and columns of the unknowns by scales.
    pub(crate) fn scale(&mut self, scales: &[f64]) {
        let pattern = Arc::clone(&self.pattern);
        let (supernodes, order) = (pattern.supernodes(), pattern.order());
        for (at, supernode) in supernodes.list.iter().enumerate() {
            let (shape, values) = (supernode.shape(), &mut self.values[supernode.values()]);
            for (column, j) in supernode.own().enumerate() {
                let of_column = scales[order[j] as usize];
                let mut part = |positions: Range<usize>, from: usize| {
                    let rows = values[from..].iter_mut().zip(&order[positions]);
                    rows.for_each(|(value, &i)| *value *= of_column * scales[i as usize]);
                };
                part(j..supernode.own().end, shape.at(column, column));
                let mut from = shape.at(QUAD * shape.own(), column);
                for run in supernodes.runs(at) {
                    part(run.positions(), from);
                    from += run.positions().len();
                }
            }
        }
    }

    /// Returns the diagonal entry of an unknown.
    pub fn diagonal_of(&self, unknown: usize) -> f64 {
        self.values[self.pattern.diagonal(self.pattern.position(unknown))]
    }

    /// Returns the entries of Φ_q: multiplier (numbered after the coordinates), coordinate, value.
    pub fn constraints(&self) -> impl Iterator<Item = (usize, usize, f64)> {
        let unknown = |at: u32| self.pattern.unknown(at as usize);
        let border = self.pattern.border().iter();
        border.map(move |b| (unknown(b.multiplier), unknown(b.coordinate), self.values[b.slot]))
    }

    /// Computes y = A x, in the order of the unknowns.
    pub fn multiply(&self, x: &[f64], y: &mut [f64]) {
        y.fill(0.0);
        self.visit_columns(|j, mut rows, mut values| {
            let (factor, mut own) = (x[j], y[j]);
            if let ([first, others @ ..], [value, below @ ..]) = (rows, values)
                && *first as usize == j
            {
                own += value * factor;
                (rows, values) = (others, below);
            }
            for (&i, &value) in rows.iter().zip(values) {
                y[i as usize] += value * factor;
                own += value * x[i as usize];
            }
            y[j] = own;
        });
    }

    /// Returns the diagonal by position.
    pub(crate) fn diagonal(&self) -> impl Iterator<Item = f64> {
        self.diagonal_from(0)
    }

    /// Returns the diagonal from a position on.
    pub(crate) fn diagonal_from(&self, position: usize) -> impl Iterator<Item = f64> {
        let list = &self.pattern.supernodes().list;
        let first = list.partition_point(|supernode| supernode.own().end <= position);
        let skipped = list.get(first).map_or(0, |supernode| position - supernode.own().start);
        let of = |supernode: &Supernode| {
            let (shape, values) = (supernode.shape(), &self.values[supernode.values()]);
            (0..shape.columns).map(move |j| values[shape.at(j, j)])
        };
        list[first..].iter().flat_map(of).skip(skipped)
    }

    /// Returns the rounding error ε max |Aᵢᵢ| of the diagonal. A stiffness below it is none: that of the orientation of a rigid body
    /// in statics is zero or a rounding error.
    pub(crate) fn diagonal_rounding(&self) -> f64 {
        f64::EPSILON * self.diagonal().map(f64::abs).fold(0.0, f64::max)
    }

    /// Returns A x, in the order of the unknowns.
    pub fn times(&self, x: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; x.len()];
        self.multiply(x, &mut product);
        product
    }

    /// Returns |A| |x|, in the order of the unknowns. ε times this bounds the rounding errors of A x.
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

    /// Returns the nonzero entries of each row, for products with sparse vectors.
    pub fn rows(&self) -> Vec<Vec<(usize, f64)>> {
        let mut rows = vec![Vec::new(); self.pattern.size()];
        self.visit(|i, j, value| {
            let (i, j) = (self.pattern.unknown(i), self.pattern.unknown(j));
            if value != 0.0 {
                rows[i].push((j, value));
                if i != j {
                    rows[j].push((i, value));
                }
            }
        });
        rows
    }

    /// Returns |x|ᵀ |A| |x|. ε times this bounds the rounding error of xᵀ A x.
    pub fn magnitude(&self, x: &[f64]) -> f64 {
        self.magnitudes(x).iter().zip(x).map(|(sum, x)| sum * x.abs()).sum()
    }

    /// Returns dense rows in the order of the unknowns, for small systems and tests.
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
