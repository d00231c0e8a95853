use std::ops::Range;

use nalgebra::{DMatrix, DVector, SymmetricEigen};

use super::columns::Columns;
use super::operator::{EigenError, Operator};

/// Selection of the eigenvalues θ of T, and their accuracy.
#[derive(Clone, Copy, Debug)]
pub(super) struct EigenSearch {
    /// Number of eigenvalues.
    pub(super) count: usize,
    /// Sort key. Eigenvalues with the largest key come first.
    pub(super) key: fn(f64) -> f64,
    /// Smallest key, relative to the largest |θ|.
    pub(super) least: f64,
    /// Tolerance: converged when |T x − θ x| ≤ tolerance · |θ|, or at the rounding error of T.
    pub(super) tolerance: f64,
    /// Number of vectors of a space above which it is restarted. The restart loses unrequested eigenvalues, which delays convergence if
    /// they are the largest.
    pub(super) capacity: usize,
}

/// Eigenpairs of the projected matrix, best first.
#[derive(Debug)]
pub(super) struct Ritz {
    values: Vec<f64>,
    vectors: DMatrix<f64>,
    order: Vec<usize>,
    /// Largest |θ|.
    pub(super) largest: f64,
    /// Number of requested pairs.
    pub(super) requested: usize,
    /// True if the requested pairs have converged.
    pub(super) converged: bool,
}

impl Ritz {
    /// Number of pairs.
    pub(super) fn count(&self) -> usize {
        self.order.len()
    }

    /// Number of the first pairs with ω² = σ + 1/θ within a distance of the lowest.
    pub(super) fn within(&self, shift: f64, distance: f64) -> usize {
        let squared = |k: &usize| shift + self.values[*k].recip();
        let lowest = self.order.first().map_or(0.0, squared);
        self.order.iter().take_while(|k| self.values[**k] > 0.0 && squared(k) <= lowest + distance).count()
    }

    /// Coefficients of pairs, the best of which is the first.
    fn weights(&self, range: Range<usize>) -> DMatrix<f64> {
        let first = range.start;
        DMatrix::from_fn(self.order.len(), range.len(), |i, k| self.vectors[(i, self.order[first + k])])
    }
}

/// Size of a remainder, relative to the vector, below which the vector is dependent.
const DEPENDENT: f64 = 1e-10;
/// Negative squares, relative to the sum of the magnitudes, beyond which the inner product is indefinite.
const INDEFINITE: f64 = 1e-10;
/// Multiple of the asymmetry of VᵀBTV below which a residual is rounding error.
const ROUNDING: f64 = 10.0;
/// Part of a vector that remains without a loss of orthogonality.
const KEPT: f64 = 0.1;

/// Block Krylov space span(X, TX, T²X, ...) with a basis V that is orthonormal in the inner product, and T V = V H for the columns to
/// which T was applied.
///
/// The basis is fully orthogonalised, block by block. A space above its capacity is restarted with its best Ritz vectors, which
/// retains all Krylov properties (thick restart). Dependent vectors are dropped.
///
/// Source: Grimes, Lewis & Simon (1994), block Lanczos with the spectral transformation; Wu & Simon (2000), thick restart; Giraud,
/// Langou & Rozložník (2005), two passes of the Gram-Schmidt method.
#[derive(Debug)]
pub(super) struct KrylovSpace {
    basis: Columns,
    columns: Vec<Vec<f64>>,
    /// Largest dimension.
    limit: usize,
}

impl KrylovSpace {
    /// Creates the space of starting vectors, with at most `limit` dimensions.
    pub(super) fn new(op: &Operator<'_>, start: Columns, limit: usize) -> Result<Self, EigenError> {
        let mut space = Self { basis: Columns::new(op.inner.diagonal().len()), columns: Vec::new(), limit };
        space.insert(op, start)?;
        Ok(space)
    }

    /// Enlarges the space by blocks until the pairs converge, but at least and at most by the given numbers of blocks.
    pub(super) fn extend(
        &mut self,
        op: &mut Operator<'_>,
        search: &EigenSearch,
        [least, most]: [usize; 2],
    ) -> Result<Ritz, EigenError> {
        let mut depth = 0;
        loop {
            let first = self.columns.len();
            let mut images = Columns::new(op.inner.diagonal().len());
            for k in first..self.basis.count() {
                images.push(op.apply(self.basis.column(k))?.as_slice());
            }
            let columns = self.insert(op, images)?;
            self.columns.extend(columns);
            depth += 1;
            let (ritz, rest) = (self.ritz(search), self.basis.count() - self.columns.len());
            if rest == 0 || depth >= most || (ritz.converged && depth >= least) {
                return Ok(ritz);
            }
            if self.columns.len() + 2 * rest > search.capacity {
                let others = self.columns.len().saturating_sub(search.count);
                self.restart(&ritz, search.count + others / 3);
            }
        }
    }

    /// Computes the best `count` Ritz vectors.
    pub(super) fn vectors(&self, ritz: &Ritz, count: usize) -> Vec<DVector<f64>> {
        self.ritz_vectors(ritz, 0..count.min(ritz.count())).vectors()
    }

    /// Computes Ritz vectors, the best of which is the first.
    pub(super) fn ritz_vectors(&self, ritz: &Ritz, range: Range<usize>) -> Columns {
        self.basis.combined(&ritz.weights(range))
    }

    /// Replaces the vectors to which T was applied by the best Ritz vectors.
    fn restart(&mut self, ritz: &Ritz, kept: usize) {
        let (n, kept) = (self.columns.len(), kept.min(ritz.count()));
        let weights = ritz.weights(0..kept);
        let mut basis = self.basis.combined(&weights);
        (n..self.basis.count()).for_each(|k| basis.push(self.basis.column(k)));
        let column = |k: usize| {
            let mut column = vec![0.0; kept];
            column[k] = ritz.values[ritz.order[k]];
            let rest = |i: usize| (0..n).map(|j| self.entry(i, j) * weights[(j, k)]).sum::<f64>();
            column.extend((n..self.basis.count()).map(rest));
            column
        };
        self.columns = (0..kept).map(column).collect();
        self.basis = basis;
    }

    /// Orthogonalises a block and adds the remainders to the basis. Returns the coefficients of its vectors.
    pub(super) fn insert(
        &mut self,
        op: &Operator<'_>,
        mut block: Columns,
    ) -> Result<Vec<Vec<f64>>, EigenError> {
        let before = (0..block.count()).map(|k| checked_size(op, block.column(k)));
        let before: Vec<f64> = before.collect::<Result<_, _>>()?;
        let mut sum = DMatrix::zeros(self.basis.count(), block.count());
        for _ in 0..2 {
            let weights = self.basis.products(&images(op, &block));
            block.add(&self.basis, &weights, -1.0);
            sum += weights;
        }
        let known = self.basis.count();
        let mut all = Vec::with_capacity(block.count());
        for (k, before) in before.into_iter().enumerate() {
            let mut coefficients: Vec<f64> = sum.column(k).iter().copied().collect();
            let mut x = DVector::from_column_slice(block.column(k));
            let mut remainder = size(op, x.as_slice());
            // The vectors before it in the block, and all vectors after a loss of digits. The remaining loss is rounding error.
            let mut from = known;
            for _ in 0..3 {
                if remainder <= DEPENDENT * before || from == self.basis.count() {
                    break;
                }
                self.project(op, &mut x, from, &mut coefficients);
                let kept = size(op, x.as_slice()) / remainder;
                remainder *= kept;
                if kept > KEPT {
                    break;
                }
                from = 0;
            }
            if remainder > DEPENDENT * before && self.basis.count() < self.limit {
                x /= remainder;
                self.basis.push(x.as_slice());
                coefficients.resize(self.basis.count() - 1, 0.0);
                coefficients.push(remainder);
            }
            all.push(coefficients);
        }
        Ok(all)
    }

    /// Subtracts the components of the basis vectors beginning with number `from`, and adds them to the coefficients.
    fn project(&self, op: &Operator<'_>, x: &mut DVector<f64>, from: usize, coefficients: &mut Vec<f64>) {
        coefficients.resize(self.basis.count(), 0.0);
        let image = DVector::from(op.inner.times(x.as_slice()));
        for (k, sum) in coefficients.iter_mut().enumerate().skip(from) {
            let v = self.basis.column(k);
            let dot: f64 = v.iter().zip(&image).map(|(v, y)| v * y).sum();
            x.iter_mut().zip(v).for_each(|(x, v)| *x -= dot * v);
            *sum += dot;
        }
    }

    /// Returns entry (i, j) of H. It is zero if the basis vector was added after the column.
    fn entry(&self, i: usize, j: usize) -> f64 {
        self.columns[j].get(i).copied().unwrap_or(0.0)
    }

    /// Computes the eigenpairs of the symmetric part of VᵀBTV. Its skew part is rounding error.
    fn ritz(&self, search: &EigenSearch) -> Ritz {
        let (n, all) = (self.columns.len(), self.basis.count());
        let h = DMatrix::from_fn(n, n, |i, j| 0.5 * (self.entry(i, j) + self.entry(j, i)));
        let skew = |i: usize, j: usize| (self.entry(i, j) - self.entry(j, i)).abs();
        let rounding = (0..n).flat_map(|i| (0..i).map(move |j| skew(i, j))).fold(0.0, f64::max);
        let (values, vectors) = eigenpairs(h);
        let mut order: Vec<usize> = (0..n).collect();
        let key = |k: &usize| (search.key)(values[*k]);
        order.sort_by(|a, b| key(b).total_cmp(&key(a)));
        let largest = values.iter().fold(0.0, |max: f64, value| max.max(value.abs()));
        let requested =
            order.iter().take(search.count).take_while(|k| key(k) > search.least * largest).count();
        let residual = |k: usize| {
            let row = |i| (0..n).map(|j| self.entry(i, j) * vectors[(j, k)]).sum::<f64>();
            (n..all).map(|i| row(i).powi(2)).sum::<f64>().sqrt()
        };
        let small =
            |&k: &usize| residual(k) <= f64::max(search.tolerance * values[k].abs(), ROUNDING * rounding);
        // Pairs that are not requested because of their keys may still approach requested ones.
        let negligible = |&k: &usize| small(&k) || residual(k) <= search.least * largest;
        let mut others = order.iter().take(search.count).skip(requested);
        let is_large = n == all || n >= search.count;
        let converged = is_large && order[..requested].iter().all(small) && others.all(negligible);
        Ritz { values, vectors, order, largest, requested, converged }
    }
}

/// Computes √(xᵀ B x). The square of a small remainder may be a negative rounding error.
fn size(op: &Operator<'_>, x: &[f64]) -> f64 {
    op.inner.square(x).max(0.0).sqrt()
}

/// Computes √(xᵀ B x) and checks that the square is neither infinite nor negative.
fn checked_size(op: &Operator<'_>, x: &[f64]) -> Result<f64, EigenError> {
    let square = op.inner.square(x);
    if !square.is_finite() {
        return Err(EigenError::Singular);
    }
    if square < 0.0 && square < -INDEFINITE * op.inner.magnitude(x) {
        return Err(EigenError::Indefinite);
    }
    Ok(square.max(0.0).sqrt())
}

/// Computes the eigenvalues and eigenvectors of a symmetric matrix, which may be empty.
fn eigenpairs(h: DMatrix<f64>) -> (Vec<f64>, DMatrix<f64>) {
    if h.is_empty() {
        return (Vec::new(), h);
    }
    let eigen = SymmetricEigen::new(h);
    (eigen.eigenvalues.data.into(), eigen.eigenvectors)
}

/// Computes B X.
fn images(op: &Operator<'_>, block: &Columns) -> Columns {
    let mut images = block.clone();
    (0..block.count()).for_each(|k| op.inner.multiply(block.column(k), images.column_mut(k)));
    images
}
