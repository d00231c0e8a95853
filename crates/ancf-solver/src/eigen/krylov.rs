use nalgebra::{DMatrix, DVector, SymmetricEigen};
use thiserror::Error;

use crate::factor::{Factor, SingularMatrix};
use crate::newton::Interrupt;
use crate::sparse::SparseMatrix;

/// Why eigenvalues were not found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum EigenError {
    /// The matrix to be inverted has no usable factorisation.
    #[error("the matrix is singular: a joint repeats another, or a motion is held by nothing")]
    Singular,
    /// The inner product is not positive: a stiffness that is none, or a negative mass.
    #[error("the matrix of the inner product is not positive definite: the state is not stable")]
    Indefinite,
    /// The permitted number of passes was not enough.
    #[error("the eigenvalues did not converge")]
    NotConverged,
    /// It was ended from outside.
    #[error("the search was interrupted")]
    Interrupted,
}

impl From<SingularMatrix> for EigenError {
    fn from(_: SingularMatrix) -> Self {
        Self::Singular
    }
}

/// T = S⁻¹ A on the x with Φ_q x = 0, self-adjoint in the inner product xᵀ B y.
///
/// S comes with its border, [S, Φ_qᵀ; Φ_q, 0], and all vectors with a tail of zeros in the place of multipliers, so that
/// the borders of A and B, whatever they are, have no effect.
#[derive(Debug)]
pub(crate) struct Operator<'a> {
    /// The factors of S.
    pub(crate) factor: &'a mut Factor,
    /// S.
    pub(crate) left: &'a SparseMatrix,
    /// A.
    pub(crate) right: &'a SparseMatrix,
    /// B.
    pub(crate) inner: &'a SparseMatrix,
    /// Number of coordinates.
    pub(crate) coordinates: usize,
    /// What may end the search.
    pub(crate) interrupt: &'a Interrupt,
}

impl Operator<'_> {
    /// T x.
    pub(crate) fn apply(&mut self, x: &DVector<f64>) -> Result<DVector<f64>, EigenError> {
        self.solve(self.right.times(x.as_slice()).into())
    }

    /// S⁻¹ f.
    fn solve(&mut self, mut f: DVector<f64>) -> Result<DVector<f64>, EigenError> {
        if self.interrupt.is_set() {
            return Err(EigenError::Interrupted);
        }
        let clear = |x: &mut DVector<f64>| x.as_mut_slice()[self.coordinates..].fill(0.0);
        clear(&mut f);
        self.factor.solve(self.left, f.as_mut_slice())?;
        clear(&mut f);
        Ok(f)
    }

    /// S⁻¹ of `count` random forces, each as large on a coordinate as the root of B's diagonal, which makes them blind to
    /// units; the same in every run.
    pub(crate) fn start(&mut self, count: usize) -> Result<Vec<DVector<f64>>, EigenError> {
        let (mut random, n) = (Random(24), self.left.pattern().size());
        let size: Vec<f64> = (0..n).map(|i| self.inner.diagonal_of(i).abs().sqrt()).collect();
        (0..count).map(|_| self.solve(DVector::from_fn(n, |i, _| size[i] * random.number()))).collect()
    }
}

/// Numbers in [−1, 1), the same in every run (SplitMix64; Steele, Lea & Flood 2014).
#[derive(Debug)]
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// An approximate eigenpair T x = θ x.
#[derive(Clone, Debug)]
pub(crate) struct Pair {
    /// θ.
    pub(crate) value: f64,
    /// x with xᵀ B x = 1.
    pub(crate) vector: DVector<f64>,
}

/// Which eigenvalues θ of T are wanted, and how well.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Search {
    /// How many.
    pub(crate) count: usize,
    /// Those first of which this is largest.
    pub(crate) key: fn(f64) -> f64,
    /// Those only of which it exceeds this part of the largest |θ|.
    pub(crate) least: f64,
    /// Converged when |T x − θ x| ≤ tolerance · |θ|, or when it is down to the rounding error of T.
    pub(crate) tolerance: f64,
    /// The largest number of blocks of a space.
    pub(crate) depth: usize,
}

/// The best pairs of a space, best first, and whether the wanted ones among them have converged.
#[derive(Debug)]
pub(crate) struct Found {
    /// As many as the starting block has, if there are so many, for it to be replaced by them.
    pub(crate) pairs: Vec<Pair>,
    /// How many of them are wanted.
    pub(crate) wanted: usize,
    /// Whether those have converged.
    pub(crate) converged: bool,
}

/// What is left of a vector counts as nothing below this part of it.
const NOTHING: f64 = 1e-10;
/// A square below zero by more than this part of what it is a sum of is negative.
const NEGATIVE: f64 = 1e-10;
/// A residual within this many times the asymmetry of VᵀBTV cannot be told from rounding.
const ROUNDING: f64 = 10.0;

/// Rayleigh-Ritz on the Krylov space of a block: span(X, TX, T²X, ...), grown until the wanted eigenvalues converge.
///
/// A block of p vectors finds eigenvalues of any multiplicity up to p, which one vector does not. Orthogonalised in full,
/// twice, vector by vector: a dependent vector is just left out.
///
/// Source: Ruhe (1979), the band Lanczos method; Parlett (1980), chapter 13.
pub(crate) fn krylov(
    op: &mut Operator<'_>,
    start: Vec<DVector<f64>>,
    search: &Search,
) -> Result<Found, EigenError> {
    let mut space = Space { inner: op.inner, basis: Vec::new(), columns: Vec::new() };
    let size = start.len();
    for x in start {
        space.insert(x)?;
    }
    let block = space.basis.len();
    if block == 0 {
        return Ok(Found { pairs: Vec::new(), wanted: 0, converged: true });
    }
    let mut depth = 0;
    loop {
        depth += 1;
        for _ in 0..block.min(space.basis.len() - space.columns.len()) {
            let image = op.apply(&space.basis[space.columns.len()])?;
            let column = space.insert(image)?;
            space.columns.push(column);
        }
        let ritz = space.ritz(search);
        if ritz.converged || depth >= search.depth {
            let pairs = (0..size.min(ritz.order.len())).map(|k| space.pair(&ritz, k)).collect();
            return Ok(Found { pairs, wanted: ritz.wanted, converged: ritz.converged });
        }
    }
}

/// An orthonormal basis V and T V = V H, column by column as far as T was applied.
struct Space<'a> {
    inner: &'a SparseMatrix,
    basis: Vec<DVector<f64>>,
    columns: Vec<Vec<f64>>,
}

/// Eigenpairs of the projected matrix, best first.
struct Ritz {
    values: Vec<f64>,
    vectors: DMatrix<f64>,
    order: Vec<usize>,
    wanted: usize,
    converged: bool,
}

impl Space<'_> {
    /// Orthogonalises a vector and adds what is left of it to the basis; returns its coefficients.
    fn insert(&mut self, mut x: DVector<f64>) -> Result<Vec<f64>, EigenError> {
        let mut coefficients = vec![0.0; self.basis.len()];
        let (mut image, square) = self.image(&x)?;
        if square < 0.0 && square < -NEGATIVE * self.inner.magnitude(x.as_slice()) {
            return Err(EigenError::Indefinite);
        }
        let before = square.max(0.0).sqrt();
        let mut size = before;
        // Once more after a loss of digits; what then is left of the loss is rounding.
        for _ in 0..3 {
            for (sum, v) in coefficients.iter_mut().zip(&self.basis) {
                let dot = v.dot(&image);
                x.axpy(-dot, v, 1.0);
                *sum += dot;
            }
            let square;
            (image, square) = self.image(&x)?;
            let kept = square.max(0.0).sqrt() / std::mem::replace(&mut size, square.max(0.0).sqrt());
            if kept > 0.1 || size <= NOTHING * before {
                break;
            }
        }
        if size > NOTHING * before {
            self.basis.push(x / size);
            coefficients.push(size);
        }
        Ok(coefficients)
    }

    /// B x and xᵀ B x.
    fn image(&self, x: &DVector<f64>) -> Result<(DVector<f64>, f64), EigenError> {
        let image = DVector::from(self.inner.times(x.as_slice()));
        let square = x.dot(&image);
        if square.is_finite() { Ok((image, square)) } else { Err(EigenError::Singular) }
    }

    /// Entry (i, j) of H; zero where a column ended before a vector joined the basis.
    fn entry(&self, i: usize, j: usize) -> f64 {
        self.columns[j].get(i).copied().unwrap_or(0.0)
    }

    /// The eigenpairs of the symmetric part of VᵀBTV; its skew part is rounding.
    fn ritz(&self, search: &Search) -> Ritz {
        let (n, all) = (self.columns.len(), self.basis.len());
        let h = DMatrix::from_fn(n, n, |i, j| 0.5 * (self.entry(i, j) + self.entry(j, i)));
        let skew = |i: usize, j: usize| (self.entry(i, j) - self.entry(j, i)).abs();
        let rounding = (0..n).flat_map(|i| (0..i).map(move |j| skew(i, j))).fold(0.0, f64::max);
        let eigen = SymmetricEigen::new(h);
        let (values, vectors) = (eigen.eigenvalues.data.into(), eigen.eigenvectors);
        let mut order: Vec<usize> = (0..n).collect();
        let key = |&k: &usize| -> f64 { (search.key)(Vec::<f64>::as_slice(&values)[k]) };
        order.sort_by(|a, b| key(b).total_cmp(&key(a)));
        let largest = values.iter().fold(0.0, |max: f64, value| max.max(value.abs()));
        let wanted = order.iter().take(search.count).take_while(|k| key(k) > search.least * largest).count();
        let residual = |k: usize| {
            let row = |i| (0..n).map(|j| self.entry(i, j) * vectors[(j, k)]).sum::<f64>();
            (n..all).map(|i| row(i).powi(2)).sum::<f64>().sqrt()
        };
        let small =
            |&k: &usize| residual(k) <= f64::max(search.tolerance * values[k].abs(), ROUNDING * rounding);
        let converged = order[..wanted].iter().all(small);
        Ritz { values, vectors, order, wanted, converged }
    }

    /// The k-th best pair.
    fn pair(&self, ritz: &Ritz, k: usize) -> Pair {
        let at = ritz.order[k];
        let mut vector = DVector::zeros(self.basis[0].len());
        for (v, &weight) in self.basis.iter().zip(&ritz.vectors.column(at)) {
            vector.axpy(weight, v, 1.0);
        }
        Pair { value: ritz.values[at], vector }
    }
}
