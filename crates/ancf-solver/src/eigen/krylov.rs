use nalgebra::{DMatrix, DVector, SymmetricEigen};
use thiserror::Error;

use crate::factor::{Factor, SingularMatrix};
use crate::newton::Interrupt;
use crate::sparse::SparseMatrix;

/// Cause of failure of an eigenvalue analysis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum EigenError {
    /// The matrix to be inverted has no usable factorisation.
    #[error("the matrix is singular: a joint is redundant, or a motion is unconstrained")]
    Singular,
    /// The inner product is not positive definite: missing stiffness or negative mass.
    #[error("the matrix of the inner product is not positive definite: the state is unstable")]
    Indefinite,
    /// The loads have no potential, so critical loads of equilibria do not determine stability.
    #[error("the loads have no potential: their stiffness is not symmetric, and the structure may flutter")]
    Nonconservative,
    /// The limit of restarts was reached.
    #[error("the eigenvalues did not converge")]
    NotConverged,
    /// The inertia of the shifted matrix contradicts the computed eigenvalues.
    #[error(
        "the number of computed eigenvalues differs from their number by the inertia of the shifted matrix"
    )]
    Missed,
    /// The interrupt flag was set.
    #[error("the eigenvalue search was interrupted")]
    Interrupted,
}

impl From<SingularMatrix> for EigenError {
    fn from(_: SingularMatrix) -> Self {
        Self::Singular
    }
}

/// Operator T = S⁻¹ A on the x with Φ_q x = 0, self-adjoint in the inner product xᵀ B y.
///
/// S is bordered, [S, Φ_qᵀ; Φ_q, 0], and all vectors have zeros instead of multipliers. The borders of A and B
/// therefore have no effect.
#[derive(Debug)]
pub(crate) struct Operator<'a> {
    /// Factors of S.
    pub(crate) factor: &'a mut Factor,
    /// Matrix S.
    pub(crate) left: &'a SparseMatrix,
    /// Matrix A.
    pub(crate) right: &'a SparseMatrix,
    /// Matrix B of the inner product.
    pub(crate) inner: &'a SparseMatrix,
    /// Number of coordinates.
    pub(crate) coordinates: usize,
    /// Interrupt flag that stops the search.
    pub(crate) interrupt: &'a Interrupt,
}

impl Operator<'_> {
    /// Computes T x.
    pub(crate) fn apply(&mut self, x: &DVector<f64>) -> Result<DVector<f64>, EigenError> {
        self.solve(self.right.times(x.as_slice()).into())
    }

    /// Computes S⁻¹ f.
    pub(crate) fn solve(&mut self, mut f: DVector<f64>) -> Result<DVector<f64>, EigenError> {
        let n = self.coordinates;
        f.as_mut_slice()[n..].fill(0.0);
        self.solve_whole(&mut f)?;
        f.as_mut_slice()[n..].fill(0.0);
        Ok(f)
    }

    /// Computes the z with Φ_q z = Φ_q x and S z = r up to reactions. The vector x − z satisfies the constraints.
    ///
    /// The second solution has the force r less the reactions, whose rounding error may exceed z.
    pub(crate) fn correction(
        &mut self,
        x: &DVector<f64>,
        mut r: DVector<f64>,
    ) -> Result<DVector<f64>, EigenError> {
        let (n, size) = (self.coordinates, r.len());
        if n == size {
            return self.solve(r);
        }
        r.rows_mut(n, size - n).copy_from_slice(&self.left.times(x.as_slice())[n..]);
        let mut reaction = r.clone();
        self.solve_whole(&mut reaction)?;
        reaction.rows_mut(0, n).fill(0.0);
        r -= DVector::from(self.left.times(reaction.as_slice()));
        self.solve_whole(&mut r)?;
        r.rows_mut(n, size - n).fill(0.0);
        Ok(r)
    }

    /// Solves with all equations. The relative error of a solution is undefined for zero.
    fn solve_whole(&mut self, f: &mut DVector<f64>) -> Result<(), EigenError> {
        if self.interrupt.is_set() {
            return Err(EigenError::Interrupted);
        }
        if f.iter().any(|&x| x != 0.0) {
            self.factor.solve(self.left, f.as_mut_slice())?;
        }
        Ok(())
    }

    /// Applies S⁻¹ to `count` pseudo-random forces, the same in every run and different for each `variant`.
    ///
    /// The forces are scaled by the root of the diagonal of B, which makes them independent of units.
    pub(crate) fn start(&mut self, count: usize, variant: u64) -> Result<Vec<DVector<f64>>, EigenError> {
        let (mut random, n) = (PseudoRandom(24 + variant), self.left.pattern().size());
        let size: Vec<f64> = (0..n).map(|i| self.inner.diagonal_of(i).abs().sqrt()).collect();
        (0..count).map(|_| self.solve(DVector::from_fn(n, |i, _| size[i] * random.number()))).collect()
    }
}

/// Pseudo-random numbers in [−1, 1), the same in every run (SplitMix64; Steele, Lea & Flood 2014).
#[derive(Debug)]
pub(crate) struct PseudoRandom(pub(crate) u64);

impl PseudoRandom {
    pub(crate) fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Approximate eigenvector T x = θ x.
#[derive(Clone, Debug)]
pub(crate) struct EigenPair {
    /// Eigenvector x with xᵀ B x = 1.
    pub(crate) vector: DVector<f64>,
}

/// Selection of the eigenvalues θ of T, and their accuracy.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EigenSearch {
    /// Number of eigenvalues.
    pub(crate) count: usize,
    /// Sort key. Eigenvalues with the largest key come first.
    pub(crate) key: fn(f64) -> f64,
    /// Smallest key, relative to the largest |θ|.
    pub(crate) least: f64,
    /// Tolerance: converged when |T x − θ x| ≤ tolerance · |θ|, or at the rounding error of T.
    pub(crate) tolerance: f64,
    /// Maximum number of blocks of a space.
    pub(crate) depth: usize,
}

/// Best eigenpairs of a space, best first.
#[derive(Debug)]
pub(crate) struct EigenSearchResult {
    /// Eigenpairs, at most as many as vectors of the starting block, which they may replace.
    pub(crate) pairs: Vec<EigenPair>,
    /// Largest |θ|.
    pub(crate) largest: f64,
    /// Number of requested pairs.
    pub(crate) requested: usize,
    /// True if the requested pairs have converged.
    pub(crate) converged: bool,
}

/// Size of a remainder, relative to the vector, below which the vector is dependent.
const DEPENDENT: f64 = 1e-10;
/// Negative squares, relative to the sum of the magnitudes, beyond which the inner product is indefinite.
const INDEFINITE: f64 = 1e-10;
/// Multiple of the asymmetry of VᵀBTV below which a residual is rounding error.
const ROUNDING: f64 = 10.0;

/// Applies the Rayleigh-Ritz method to the block Krylov space span(X, TX, T²X, ...), enlarged until convergence.
///
/// A block of p vectors finds eigenvalues of any multiplicity up to p, unlike a single vector. The basis is fully
/// orthogonalised, twice, vector by vector. Dependent vectors are dropped.
///
/// Source: Ruhe (1979), the band Lanczos method; Parlett (1980), chapter 13.
pub(crate) fn krylov(
    op: &mut Operator<'_>,
    start: Vec<DVector<f64>>,
    search: &EigenSearch,
) -> Result<EigenSearchResult, EigenError> {
    let mut space = KrylovSpace { inner: op.inner, basis: Vec::new(), columns: Vec::new() };
    let size = start.len();
    for x in start {
        space.insert(x)?;
    }
    let block = space.basis.len();
    if block == 0 {
        return Ok(EigenSearchResult { pairs: Vec::new(), largest: 0.0, requested: 0, converged: true });
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
            let Ritz { largest, requested, converged, .. } = ritz;
            return Ok(EigenSearchResult { pairs, largest, requested, converged });
        }
    }
}

/// Orthonormal basis V and T V = V H, for the columns to which T was applied.
struct KrylovSpace<'a> {
    inner: &'a SparseMatrix,
    basis: Vec<DVector<f64>>,
    columns: Vec<Vec<f64>>,
}

/// Eigenpairs of the projected matrix, best first.
struct Ritz {
    vectors: DMatrix<f64>,
    order: Vec<usize>,
    largest: f64,
    requested: usize,
    converged: bool,
}

impl KrylovSpace<'_> {
    /// Orthogonalises a vector and adds the remainder to the basis. Returns its coefficients.
    fn insert(&mut self, mut x: DVector<f64>) -> Result<Vec<f64>, EigenError> {
        let mut coefficients = vec![0.0; self.basis.len()];
        let (mut image, square) = self.image(&x)?;
        if square < 0.0 && square < -INDEFINITE * self.inner.magnitude(x.as_slice()) {
            return Err(EigenError::Indefinite);
        }
        let before = square.max(0.0).sqrt();
        let mut size = before;
        // Repetition after a loss of digits. The remaining loss is rounding error.
        for _ in 0..3 {
            for (sum, v) in coefficients.iter_mut().zip(&self.basis) {
                let dot = v.dot(&image);
                x.axpy(-dot, v, 1.0);
                *sum += dot;
            }
            let square;
            (image, square) = self.image(&x)?;
            let kept = square.max(0.0).sqrt() / std::mem::replace(&mut size, square.max(0.0).sqrt());
            if kept > 0.1 || size <= DEPENDENT * before {
                break;
            }
        }
        if size > DEPENDENT * before {
            self.basis.push(x / size);
            coefficients.push(size);
        }
        Ok(coefficients)
    }

    /// Computes B x and xᵀ B x.
    fn image(&self, x: &DVector<f64>) -> Result<(DVector<f64>, f64), EigenError> {
        let image = DVector::from(self.inner.times(x.as_slice()));
        let square = x.dot(&image);
        if square.is_finite() { Ok((image, square)) } else { Err(EigenError::Singular) }
    }

    /// Returns entry (i, j) of H. It is zero if the basis vector was added after the column.
    fn entry(&self, i: usize, j: usize) -> f64 {
        self.columns[j].get(i).copied().unwrap_or(0.0)
    }

    /// Computes the eigenpairs of the symmetric part of VᵀBTV. Its skew part is rounding error.
    fn ritz(&self, search: &EigenSearch) -> Ritz {
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
        let converged = order[..requested].iter().all(small) && others.all(negligible);
        Ritz { vectors, order, largest, requested, converged }
    }

    /// Returns the k-th best pair.
    fn pair(&self, ritz: &Ritz, k: usize) -> EigenPair {
        let at = ritz.order[k];
        let mut vector = DVector::zeros(self.basis[0].len());
        for (v, &weight) in self.basis.iter().zip(&ritz.vectors.column(at)) {
            vector.axpy(weight, v, 1.0);
        }
        EigenPair { vector }
    }
}
