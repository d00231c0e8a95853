use std::fmt;
use std::sync::Arc;

use faer::MatMut;
use faer::prelude::Solve;
use faer::sparse::linalg::solvers::{Lu, SymbolicLu};
use faer::sparse::{SparseColMat, Triplet};
use serde::{Deserialize, Serialize};

use super::ldlt::Ldlt;
use crate::sparse::{Pattern, SparseMatrix};

/// The factorisation of a symmetric indefinite matrix: LDLᵀ in panels without pivoting, checked at every solve but for
/// increments after a first one that needed no refinement.
///
/// Without pivoting, rounding in LDLᵀ does not depend on how rows and columns are scaled together, so units and
/// slope lengths do not matter to it. What it loses when a stiffness is indefinite is seen in the backward error
/// ‖D(b − Ax)‖ / (‖D⁻¹x‖ + ‖Db‖) (maximum norms), where D A D has entries of size one and the error no units: it is
/// refined, and if that does not help, LU with pivoting takes over. Symbolic analysis happens once.
///
/// Where constraints are redundant, K is singular and multipliers are *shared* ([`System::sharing`](crate::equations::System::sharing)).
/// What is factorised then has a compliance −ε/D² in their diagonal, K_ε = K − εE: of all multipliers that satisfy the
/// equations it picks those of least λᵀEλ, since Φ_q Δq − εE λ = −Φ puts Eλ into the range of Φ_q. What ε changes besides is
/// taken back by steps K_ε Δx = b − K x, each of which leaves no more than about ε of it.
///
/// Source: Rigal & Gaches (1967) for the error; faer for LU; Bertsekas (1982), the method of multipliers.
pub struct Factor {
    ldlt: Ldlt,
    pattern: Arc<Pattern>,
    lu: Option<Lu<usize, f64>>,
    /// If multipliers are shared.
    shared: Option<Box<Shared>>,
    /// Whether the factors have solved equations without refinement.
    proven: bool,
    /// Equilibration D, right-hand side, solution and residual, in positions.
    d: Vec<f64>,
    b: Vec<f64>,
    x: Vec<f64>,
    r: Vec<f64>,
}

/// What became of a factorisation since it was made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Course {
    /// Whether LU has taken over.
    lu: bool,
    /// Whether the factors have solved equations without refinement.
    proven: bool,
}

impl Course {
    /// Nothing yet.
    pub const NEW: Self = Self { lu: false, proven: false };
}

/// What shared multipliers need besides.
struct Shared {
    /// K_ε.
    compliant: SparseMatrix,
    /// Right-hand side and solution of K, in positions.
    b: Vec<f64>,
    x: Vec<f64>,
}

impl fmt::Debug for Factor {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Factor")
            .field("size", &self.b.len())
            .field("entries", &self.pattern.entries())
            .finish()
    }
}

/// The matrix has no usable factorisation: a redundant constraint, a free motion or numbers that are not finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SingularMatrix;

/// Backward errors above this are refined.
const REFINE: f64 = 1e-11;
/// Backward errors above this after refinement are not accepted.
const ACCEPT: f64 = 1e-9;
/// ε: well above rounding, and well below what is solved in a few steps.
const COMPLIANCE: f64 = 1e-6;
/// Steps from K_ε to K.
const STEPS: u32 = 3;
/// Backward errors of K above this tell that redundant constraints contradict each other.
const CONTRADICT: f64 = 1e-6;

impl Factor {
    /// Analyses a pattern.
    ///
    /// # Errors
    /// If memory or the range of indices does not suffice.
    pub fn new(pattern: &Arc<Pattern>) -> Result<Self, SingularMatrix> {
        let zeros = vec![0.0; pattern.size()];
        Ok(Self {
            ldlt: Ldlt::new(pattern.panels()),
            pattern: Arc::clone(pattern),
            lu: None,
            shared: (!pattern.shared().is_empty()).then(|| {
                let compliant = SparseMatrix::zero(Arc::clone(pattern));
                Box::new(Shared { compliant, b: zeros.clone(), x: zeros.clone() })
            }),
            proven: false,
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
        self.equilibrate(k);
        let Some(mut shared) = self.shared.take() else { return self.factorise_as_is(k) };
        let values = shared.compliant.values_mut();
        values.copy_from_slice(k.values());
        for &at in self.pattern.shared() {
            values[self.pattern.diagonal(at)] -= COMPLIANCE / self.d[at].powi(2);
        }
        let done = self.factorise_as_is(&shared.compliant);
        self.shared = Some(shared);
        done
    }

    fn factorise_as_is(&mut self, k: &SparseMatrix) -> Result<(), SingularMatrix> {
        (self.lu, self.proven) = (None, false);
        let done = self.ldlt.factorise(self.pattern.panels(), k.values());
        if done.is_err() { self.factorise_by_lu(k) } else { Ok(()) }
    }

    /// What became of the current factors.
    pub fn course(&self) -> Course {
        Course { lu: self.lu.is_some(), proven: self.proven }
    }

    /// Factorises a matrix as it was done before, to the factors that it had in the end.
    ///
    /// # Errors
    /// If neither LDLᵀ nor LU succeeds.
    pub fn factorise_again(&mut self, k: &SparseMatrix, course: Course) -> Result<(), SingularMatrix> {
        self.factorise(k)?;
        if course.lu && self.lu.is_none() {
            match self.shared.take() {
                None => self.factorise_by_lu(k)?,
                Some(shared) => {
                    let done = self.factorise_by_lu(&shared.compliant);
                    self.shared = Some(shared);
                    done?;
                }
            }
        }
        self.proven = course.proven;
        Ok(())
    }

    /// Solves K x = b in place with the factors of K; `x` holds b on entry, in the order of the unknowns.
    ///
    /// # Errors
    /// If no factorisation solves the equations to a small backward error, or redundant constraints contradict each other.
    pub fn solve(&mut self, k: &SparseMatrix, x: &mut [f64]) -> Result<(), SingularMatrix> {
        let error = self.solve_from(k, x, None)?;
        if error <= CONTRADICT { Ok(()) } else { Err(SingularMatrix) }
    }

    /// The same for an increment x of a state with multipliers λ, such that those shared are least after it, not in it.
    ///
    /// What redundant constraints contradict each other is left as it is, as away from Φ = 0 they may. Errors of an increment are
    /// seen in the next residual: factors that have proven themselves are not checked again.
    ///
    /// # Errors
    /// If no factorisation solves the equations to a small backward error.
    pub fn solve_increment(
        &mut self,
        k: &SparseMatrix,
        x: &mut [f64],
        lambda: &[f64],
    ) -> Result<(), SingularMatrix> {
        self.solve_from(k, x, Some(lambda)).map(|_| ())
    }

    /// Returns the backward error if multipliers are shared, else zero for one that is accepted.
    fn solve_from(
        &mut self,
        k: &SparseMatrix,
        x: &mut [f64],
        lambda: Option<&[f64]>,
    ) -> Result<f64, SingularMatrix> {
        for (unknown, &value) in x.iter().enumerate() {
            self.b[self.pattern.position(unknown)] = value;
        }
        let error = match self.shared.take() {
            None if self.proven && lambda.is_some() => {
                self.x.copy_from_slice(&self.b);
                self.substitute(false);
                Ok(0.0)
            }
            None => self.solve_as_is(k).map(|()| 0.0),
            Some(mut shared) => {
                let error = self.solve_shared(k, &mut shared, lambda.unwrap_or_default());
                self.shared = Some(shared);
                error
            }
        }?;
        for (unknown, value) in x.iter_mut().enumerate() {
            *value = self.x[self.pattern.position(unknown)];
        }
        Ok(error)
    }

    /// Solves K x = `b` into `x`, by LU if LDLᵀ does not do.
    fn solve_as_is(&mut self, k: &SparseMatrix) -> Result<(), SingularMatrix> {
        if self.refined(k).is_err() {
            if self.lu.is_some() {
                return Err(SingularMatrix);
            }
            self.factorise_by_lu(k)?;
            self.refined(k)?;
        }
        Ok(())
    }

    /// Solves K x = `b` into `x` by steps with K_ε; returns the backward error.
    fn solve_shared(
        &mut self,
        k: &SparseMatrix,
        shared: &mut Shared,
        lambda: &[f64],
    ) -> Result<f64, SingularMatrix> {
        shared.b.copy_from_slice(&self.b);
        shared.x.fill(0.0);
        let coordinates = self.b.len() - lambda.len();
        for &at in self.pattern.shared().iter().filter(|_| !lambda.is_empty()) {
            self.b[at] += COMPLIANCE / self.d[at].powi(2) * lambda[self.pattern.unknown(at) - coordinates];
        }
        let mut steps = 0;
        loop {
            self.solve_as_is(&shared.compliant)?;
            shared.x.iter_mut().zip(&self.x).for_each(|(sum, x)| *sum += x);
            self.x.copy_from_slice(&shared.x);
            self.b.copy_from_slice(&shared.b);
            let error = self.backward_error(k);
            steps += 1;
            if error <= REFINE || steps > STEPS {
                return Ok(error);
            }
            self.b.copy_from_slice(&self.r);
        }
    }

    /// Solves for `b` into `x` with up to two steps of iterative refinement.
    fn refined(&mut self, k: &SparseMatrix) -> Result<(), SingularMatrix> {
        self.x.copy_from_slice(&self.b);
        self.substitute(false);
        let mut error = self.backward_error(k);
        self.proven = error <= REFINE;
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
        match &self.lu {
            Some(lu) => {
                let n = target.len();
                lu.solve_in_place(MatMut::from_column_major_slice_mut(target, n, 1));
            }
            None => self.ldlt.solve(self.pattern.panels(), target),
        }
    }

    /// Residual r = b − K x and the backward error; infinite if anything is not finite.
    fn backward_error(&mut self, k: &SparseMatrix) -> f64 {
        let Self { ldlt, pattern, d, b, x, r, .. } = self;
        r.copy_from_slice(b);
        ldlt.subtract_product(pattern.panels(), k.values(), x, r);
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
    ///
    /// The diagonal of a coordinate without mass may be next to nothing, as a multiplier is: its scale is at most that by which
    /// it counts as much as others in an equation that determines it.
    fn equilibrate(&mut self, k: &SparseMatrix) {
        let Self { d, r: largest, x: bound, .. } = self;
        d.iter_mut().zip(k.diagonal()).for_each(|(d, diagonal)| *d = diagonal);
        for d in &mut *d {
            *d = if *d == 0.0 { 1.0 } else { 1.0 / d.abs().sqrt() };
        }
        let massless = k.pattern().massless();
        if !massless.is_empty() {
            bound.fill(f64::INFINITY);
            massless.iter().for_each(|&at| d[at] = 0.0);
            scale_multipliers(k, d, largest);
            for border in k.pattern().border().iter().filter(|border| d[border.coordinate] == 0.0) {
                let (entry, others) = (k.values()[border.slot].abs(), largest[border.multiplier]);
                if entry > 0.0 && others > 0.0 {
                    bound[border.coordinate] = bound[border.coordinate].min(others / entry);
                }
            }
            for &at in massless {
                let own = 1.0 / k.values()[k.pattern().diagonal(at)].abs().sqrt();
                d[at] = Some(own.min(bound[at])).filter(|d| d.is_finite()).unwrap_or(1.0);
            }
        }
        scale_multipliers(k, d, largest);
        for (d, &largest) in d.iter_mut().zip(&*largest) {
            if largest > 0.0 {
                *d = 1.0 / largest;
            }
        }
    }

    /// Factorises the full matrix by LU with pivoting.
    fn factorise_by_lu(&mut self, k: &SparseMatrix) -> Result<(), SingularMatrix> {
        let n = self.b.len();
        let mut entries = Vec::new();
        k.visit(|i, j, value| {
            // What only fills up panels.
            if value == 0.0 {
                return;
            }
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

/// The largest entry of each multiplier, scaled by the D of its coordinate.
fn scale_multipliers(k: &SparseMatrix, d: &[f64], largest: &mut [f64]) {
    largest.fill(0.0);
    for border in k.pattern().border() {
        let entry = k.values()[border.slot].abs() * d[border.coordinate];
        largest[border.multiplier] = largest[border.multiplier].max(entry);
    }
}

impl Factor {
    /// Whether the current factorisation is the LU fallback.
    pub fn is_lu(&self) -> bool {
        self.lu.is_some()
    }

    /// The scale of a coordinate: one over the root of its diagonal entry in the matrix factorised last.
    pub fn scale(&self, coordinate: usize) -> f64 {
        self.d[self.pattern.position(coordinate)]
    }

    /// The number of negative entries of D in the current L D Lᵀ: as many as K has negative eigenvalues.
    ///
    /// `None` if LU has taken over, whose pivots tell nothing of eigenvalues.
    ///
    /// Source: Sylvester (1852), the law of inertia.
    pub fn negative_pivots(&self) -> Option<usize> {
        let negative = || self.ldlt.inverse_pivots().iter().filter(|inverse| **inverse < 0.0).count();
        self.lu.is_none().then(negative)
    }
}
