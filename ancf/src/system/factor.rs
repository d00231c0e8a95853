use std::fmt;
use std::sync::Arc;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::ldlt::factor::LdltRegularization;
use faer::prelude::Solve;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::supernodal::SupernodalLdltRef;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LdltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::linalg::solvers::{Lu, SymbolicLu};
use faer::sparse::{SparseColMat, SparseColMatRef, SymbolicSparseColMatRef, Triplet};
use faer::{Conj, MatMut, Par, Side, Spec};

use super::{Pattern, SparseMatrix};

/// The factorisation of a symmetric indefinite matrix: supernodal LDLᵀ without pivoting, checked at every solve.
///
/// Without pivoting, rounding in LDLᵀ does not depend on how rows and columns are scaled together, so units and
/// slope lengths do not matter to it. What it loses when a stiffness is indefinite is seen in the backward error
/// ‖D(b − Ax)‖ / (‖D⁻¹x‖ + ‖Db‖) (maximum norms), where D A D has entries of size one and the error no units: it is
/// refined, and if that does not help, LU with pivoting takes over. Symbolic analysis happens once.
///
/// Source: Rigal & Gaches (1967) for the error; faer for the factorisations.
pub struct Factor {
    symbolic: SymbolicCholesky<usize>,
    values: Vec<f64>,
    memory: MemBuffer,
    pattern: Arc<Pattern>,
    lu: Option<Lu<usize, f64>>,
    /// Equilibration D, right-hand side, solution and residual, in positions.
    d: Vec<f64>,
    b: Vec<f64>,
    x: Vec<f64>,
    r: Vec<f64>,
}

impl fmt::Debug for Factor {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Factor").field("size", &self.b.len()).field("entries", &self.values.len()).finish()
    }
}

/// The matrix has no usable factorisation: a redundant constraint, a free motion or numbers that are not finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SingularMatrix;

/// Backward errors above this are refined.
const REFINE: f64 = 1e-11;
/// Backward errors above this after refinement are not accepted.
const ACCEPT: f64 = 1e-9;

impl Factor {
    /// Analyses a pattern.
    ///
    /// # Errors
    /// If memory or the range of indices does not suffice.
    pub fn new(pattern: &Arc<Pattern>) -> Result<Self, SingularMatrix> {
        let params = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
            ..CholeskySymbolicParams::default()
        };
        // Without a permutation faer's analysis reads the upper triangle, whatever the side; its numeric part the lower.
        let (columns, rows) = pattern.upper();
        let upper =
            SymbolicSparseColMatRef::new_checked(pattern.size(), pattern.size(), &columns, None, &rows);
        let symbolic = factorize_symbolic_cholesky(upper, Side::Upper, SymmetricOrdering::Identity, params)
            .map_err(|_| SingularMatrix)?;
        let scratch =
            symbolic
                .factorize_numeric_ldlt_scratch::<f64>(Par::Seq, Spec::default())
                .or(symbolic.solve_in_place_scratch::<f64>(1, Par::Seq));
        let zeros = vec![0.0; pattern.size()];
        Ok(Self {
            values: vec![0.0; symbolic.len_val()],
            memory: MemBuffer::new(scratch),
            pattern: Arc::clone(pattern),
            symbolic,
            lu: None,
            d: zeros.clone(),
            b: zeros.clone(),
            x: zeros.clone(),
            r: zeros,
        })
    }

    /// Factorises a matrix of the analysed pattern.
    ///
    /// # Errors
    /// If neither LDLᵀ nor LU succeeds.
    pub fn factorise(&mut self, k: &SparseMatrix) -> Result<(), SingularMatrix> {
        self.lu = None;
        self.equilibrate(k);
        let done = self.symbolic.factorize_numeric_ldlt(
            &mut self.values,
            SparseColMatRef::new(k.pattern().symbolic(), k.values()),
            Side::Lower,
            LdltRegularization::default(),
            Par::Seq,
            MemStack::new(&mut self.memory),
            Spec::default(),
        );
        if done.is_err() { self.factorise_by_lu(k) } else { Ok(()) }
    }

    /// Solves K x = b in place with the factors of K; `x` holds b on entry, in the order of the unknowns.
    ///
    /// # Errors
    /// If no factorisation solves the equations to a small backward error.
    pub fn solve(&mut self, k: &SparseMatrix, x: &mut [f64]) -> Result<(), SingularMatrix> {
        for (unknown, &value) in x.iter().enumerate() {
            self.b[self.pattern.position(unknown)] = value;
        }
        if self.refined(k).is_err() {
            if self.lu.is_some() {
                return Err(SingularMatrix);
            }
            self.factorise_by_lu(k)?;
            self.refined(k)?;
        }
        for (unknown, value) in x.iter_mut().enumerate() {
            *value = self.x[self.pattern.position(unknown)];
        }
        Ok(())
    }

    /// Solves for `b` into `x` with up to two steps of iterative refinement.
    fn refined(&mut self, k: &SparseMatrix) -> Result<(), SingularMatrix> {
        self.x.copy_from_slice(&self.b);
        self.substitute(false);
        let mut error = self.backward_error(k);
        for _ in 0..2 {
            if error <= REFINE {
                return Ok(());
            }
            self.substitute(true);
            for (x, r) in self.x.iter_mut().zip(&self.r) {
                *x += r;
            }
            error = self.backward_error(k);
        }
        if error <= ACCEPT { Ok(()) } else { Err(SingularMatrix) }
    }

    /// Forward and backward substitution of `x`, or of the residual `r`, in place.
    fn substitute(&mut self, residual: bool) {
        let target = if residual { &mut self.r } else { &mut self.x };
        let n = target.len();
        let rhs = MatMut::from_column_major_slice_mut(target, n, 1);
        match &self.lu {
            Some(lu) => lu.solve_in_place(rhs),
            None => LdltRef::new(&self.symbolic, &self.values).solve_in_place_with_conj(
                Conj::No,
                rhs,
                Par::Seq,
                MemStack::new(&mut self.memory),
            ),
        }
    }

    /// Residual r = b − K x and the backward error; infinite if anything is not finite.
    fn backward_error(&mut self, k: &SparseMatrix) -> f64 {
        let Self { d, b, x, r, .. } = self;
        r.copy_from_slice(b);
        k.subtract_product(x, r);
        let (mut residual, mut size): (f64, f64) = (0.0, 0.0);
        for i in 0..b.len() {
            if !r[i].is_finite() {
                return f64::INFINITY;
            }
            residual = residual.max(r[i].abs() * d[i]);
            size = size.max(b[i].abs() * d[i]).max(x[i].abs() / d[i]);
        }
        if residual == 0.0 { 0.0 } else { residual / size }
    }

    /// D: one over the root of the diagonal; for multipliers, where that is zero, one over the largest scaled entry.
    fn equilibrate(&mut self, k: &SparseMatrix) {
        let Self { d, r: largest, .. } = self;
        largest.fill(0.0);
        for (d, diagonal) in d.iter_mut().zip(k.diagonal()) {
            *d = if diagonal == 0.0 { 1.0 } else { 1.0 / diagonal.abs().sqrt() };
        }
        for border in k.pattern().border() {
            let entry = k.values()[border.slot].abs() * d[border.coordinate];
            largest[border.multiplier] = largest[border.multiplier].max(entry);
        }
        for (d, &largest) in d.iter_mut().zip(&*largest) {
            if largest > 0.0 {
                *d = 1.0 / largest;
            }
        }
    }

    /// Factorises the full matrix by LU with pivoting.
    fn factorise_by_lu(&mut self, k: &SparseMatrix) -> Result<(), SingularMatrix> {
        let n = self.b.len();
        let mut entries = Vec::with_capacity(2 * k.values().len());
        k.visit(|i, j, value| {
            entries.push(Triplet::new(i, j, value));
            if i != j {
                entries.push(Triplet::new(j, i, value));
            }
        });
        let full = SparseColMat::try_new_from_triplets(n, n, &entries).map_err(|_| SingularMatrix)?;
        let symbolic = SymbolicLu::try_new(full.symbolic()).map_err(|_| SingularMatrix)?;
        self.lu = Some(Lu::try_new_with_symbolic(symbolic, full.as_ref()).map_err(|_| SingularMatrix)?);
        Ok(())
    }
}

impl Factor {
    /// Whether the current factorisation is the LU fallback.
    pub fn is_lu(&self) -> bool {
        self.lu.is_some()
    }

    /// The number of negative entries of D in the current L D Lᵀ: as many as K has negative eigenvalues.
    ///
    /// `None` if LU has taken over, whose pivots tell nothing of eigenvalues.
    ///
    /// Source: Sylvester (1852), the law of inertia; the diagonal of faer's supernodes is D.
    pub fn negative_pivots(&self) -> Option<usize> {
        let (SymbolicCholeskyRaw::Supernodal(symbolic), None) = (self.symbolic.raw(), &self.lu) else {
            return None;
        };
        let factors = SupernodalLdltRef::new(symbolic, &self.values);
        let negative = |s| {
            let block = factors.supernode(s).val();
            (0..block.ncols()).filter(|&j| block[(j, j)] < 0.0).count()
        };
        Some((0..symbolic.n_supernodes()).map(negative).sum())
    }
}
