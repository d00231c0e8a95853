use std::fmt;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::conjugate_residuals::ConjugateResiduals;
use super::multifrontal::Ldlt;
use super::scaled_lu::ScaledLu;
use super::scales::{equilibrate, match_scales};
use crate::sparse::{FactorStorage, Pattern, SparseMatrix};
use crate::vectors::{copy, for_each_chunk, largest_of_chunks};

/// Supernodal LDLᵀ factorisation of a symmetric indefinite matrix without pivoting, with LU as a fallback.
///
/// Every solution is checked by its backward error. Increments are exempt after a first one without refinement.
///
/// Without pivoting, rounding errors of LDLᵀ do not depend on a symmetric scaling. Units and slope lengths therefore
/// have no effect. An indefinite stiffness may cause a loss of accuracy. It appears in the backward error
/// ‖D(b − Ax)‖ / (‖D⁻¹x‖ + ‖Db‖) (maximum norms), where D A D has entries of size one and the error no units. Large
/// errors are reduced by iterative refinement. If that fails, LU with pivoting is used. The symbolic analysis is
/// performed once.
///
/// With redundant constraints, K is singular and multipliers are *shared*
/// ([`System::with_shared_multipliers`](crate::equations::System::with_shared_multipliers)). The factorised matrix K_ε = K − εE then has a compliance
/// −ε/D² on their diagonal. Among all multipliers that satisfy the equations it selects those with minimal λᵀEλ, since
/// Φ_q Δq − εE λ = −Φ places Eλ in the range of Φ_q. Conjugate residuals with K_ε remove the other effects of ε.
///
/// Source: Rigal & Gaches (1967) for the error; Bertsekas (1982), the method of multipliers.
pub struct Factor {
    pub(super) ldlt: Ldlt,
    pub(super) pattern: Arc<Pattern>,
    pub(super) lu: Option<ScaledLu>,
    /// Storage for shared multipliers, if there are any.
    pub(super) shared: Option<Box<SharedMultipliers>>,
    /// True if the factors have solved equations without refinement.
    verified: bool,
    /// Rounding error ε max |Kᵢᵢ| of the diagonal.
    rounding: f64,
    /// Equilibration D, right-hand side, solution and residual, by position.
    pub(super) d: Vec<f64>,
    pub(super) b: Vec<f64>,
    pub(super) x: Vec<f64>,
    pub(super) r: Vec<f64>,
}

/// History of a factorisation, from which it can be repeated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct FactorHistory {
    /// True if the LU fallback is active.
    lu: bool,
    /// True if the factors have solved equations without refinement.
    verified: bool,
}

impl FactorHistory {
    /// History of a new factorisation.
    pub const NEW: Self = Self { lu: false, verified: false };
}

/// Additional storage for shared multipliers.
pub(super) struct SharedMultipliers {
    /// Compliant matrix K_ε.
    compliant: SparseMatrix,
    /// Right-hand side, solution and residual of K, by position.
    b: Vec<f64>,
    x: Vec<f64>,
    r: Vec<f64>,
    steps: ConjugateResiduals,
    /// True in statics of rigid bodies, where no energy measures the gaps of constraints.
    pub(super) is_rigid: bool,
}

impl fmt::Debug for Factor {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Factor")
            .field("size", &self.b.len())
            .field("entries", &self.pattern.entries())
            .finish()
    }
}

/// Singular matrix: a redundant constraint, an unconstrained motion or entries that are not finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SingularMatrix;

/// Backward error above which a solution is refined.
const REFINE: f64 = 1e-11;
/// Largest accepted backward error after refinement.
const ACCEPT: f64 = 1e-9;
/// Relative change in a further step of refinement above which a result is a rounding error.
pub(crate) const DETERMINED: f64 = 1e-3;
/// Compliance ε, far above rounding and small enough for fast convergence.
pub(super) const COMPLIANCE: f64 = 1e-6;
/// Largest number of steps from K_ε to K, and the reduction of the residual by a step without which they end.
const STEPS: u32 = 60;
const REDUCTION: f64 = 0.99;
/// Residual below which subnormal numbers, which have fewer digits, cause any backward error.
const UNDERFLOW: f64 = f64::MIN_POSITIVE / f64::EPSILON;
/// Backward error of K above which redundant constraints are contradictory.
const CONTRADICTION: f64 = 1e-6;

impl Factor {
    /// Analyses a pattern.
    ///
    /// # Errors
    /// If the memory or the range of indices does not suffice.
    pub fn new(pattern: &Arc<Pattern>) -> Result<Self, SingularMatrix> {
        let zeros = vec![0.0; pattern.size()];
        Ok(Self {
            ldlt: Ldlt::new(pattern.supernodes(), pattern.factor_storage()),
            pattern: Arc::clone(pattern),
            lu: None,
            shared: (!pattern.shared().is_empty()).then(|| {
                let compliant = SparseMatrix::zero(Arc::clone(pattern));
                let [b, x, r] = std::array::from_fn(|_| zeros.clone());
                Box::new(SharedMultipliers {
                    compliant,
                    b,
                    x,
                    r,
                    steps: ConjugateResiduals::default(),
                    is_rigid: false,
                })
            }),
            verified: false,
            rounding: 0.0,
            d: zeros.clone(),
            b: zeros.clone(),
            x: zeros.clone(),
            r: zeros,
        })
    }

    /// Returns the memory of a matrix and its factors in bytes, without lists of the pattern.
    pub fn memory(pattern: &Pattern, storage: FactorStorage) -> f64 {
        (size_of::<f64>() * (pattern.entries() + Ldlt::values(pattern.supernodes(), storage))) as f64
    }

    /// Factorises a matrix of the analysed pattern.
    ///
    /// # Errors
    /// If neither LDLᵀ nor LU succeeds.
    pub fn factorise(&mut self, k: &SparseMatrix) -> Result<(), SingularMatrix> {
        self.rounding = equilibrate(k, &mut self.d, [&mut self.r, &mut self.x]);
        let Some(mut shared) = self.shared.take() else { return self.factorise_plain(k) };
        shared.is_rigid = match_scales(k, self.rounding, &mut self.d, [&mut self.r, &mut self.x]);
        let values = shared.compliant.values_mut();
        values.copy_from_slice(k.values());
        for &at in self.pattern.shared() {
            values[self.pattern.diagonal(at)] -= COMPLIANCE / self.d[at].powi(2);
        }
        let done = self.factorise_plain(&shared.compliant);
        self.shared = Some(shared);
        done
    }

    fn factorise_plain(&mut self, k: &SparseMatrix) -> Result<(), SingularMatrix> {
        (self.lu, self.verified) = (None, false);
        let done = self.ldlt.factorise(self.pattern.supernodes(), k.values());
        if done.is_err() || self.has_pivot_of_rounding() { self.factorise_by_lu(k) } else { Ok(()) }
    }

    /// Returns true if a constrained coordinate has a pivot below the rounding error of the largest diagonal.
    ///
    /// The stiffness of a rigid body in statics is an example: it is zero, or a rounding error of the multipliers. The factors
    /// of its constraints would consist of rounding errors.
    fn has_pivot_of_rounding(&self) -> bool {
        let inverse = self.ldlt.inverse_pivots();
        self.pattern.constrained().any(|at| inverse[at].abs() * self.rounding > 1.0)
    }

    /// Returns the history of the current factors.
    pub fn history(&self) -> FactorHistory {
        FactorHistory { lu: self.lu.is_some(), verified: self.verified }
    }

    /// Repeats a factorisation with its history, which reproduces the final factors.
    ///
    /// # Errors
    /// If neither LDLᵀ nor LU succeeds.
    pub fn refactorise(&mut self, k: &SparseMatrix, history: FactorHistory) -> Result<(), SingularMatrix> {
        self.factorise(k)?;
        if history.lu && self.lu.is_none() {
            match self.shared.take() {
                None => self.factorise_by_lu(k)?,
                Some(shared) => {
                    let done = self.factorise_by_lu(&shared.compliant);
                    self.shared = Some(shared);
                    done?;
                }
            }
        }
        self.verified = history.verified;
        Ok(())
    }

    /// Solves K x = b in place with the factors of K. On entry `x` contains b, in the order of the unknowns.
    ///
    /// # Errors
    /// If no factorisation gives a small backward error, or redundant constraints are contradictory.
    pub fn solve(&mut self, k: &SparseMatrix, x: &mut [f64]) -> Result<(), SingularMatrix> {
        let error = self.solve_from(k, x, None)?;
        if error <= CONTRADICTION { Ok(()) } else { Err(SingularMatrix) }
    }

    /// Solves for an increment x of a state with multipliers λ. The shared multipliers are minimal after the increment.
    ///
    /// Contradictions of redundant constraints are ignored, since they may occur away from Φ = 0. Errors of an
    /// increment appear in the next residual. Factors with a successful solution are therefore not checked again.
    ///
    /// # Errors
    /// If no factorisation gives a small backward error.
    pub fn solve_increment(
        &mut self,
        k: &SparseMatrix,
        x: &mut [f64],
        lambda: &[f64],
    ) -> Result<(), SingularMatrix> {
        self.solve_from(k, x, Some(lambda)).map(|_| ())
    }

    /// Returns a solution of K x = b after a further step of refinement.
    ///
    /// Parts of x that are zero but for rounding errors change by their own size. The backward error does not show them, since
    /// it is relative to the largest part.
    ///
    /// # Errors
    /// If no factorisation gives a small backward error.
    pub(crate) fn refined(
        &mut self,
        k: &SparseMatrix,
        b: &[f64],
        x: &[f64],
    ) -> Result<Vec<f64>, SingularMatrix> {
        let mut correction: Vec<f64> = b.iter().zip(k.times(x)).map(|(b, product)| b - product).collect();
        if correction.iter().any(|x| *x != 0.0) {
            // The error of the factors is not a contradiction of redundant constraints.
            self.solve_increment(k, &mut correction, &[])?;
        }
        Ok(x.iter().zip(&correction).map(|(x, correction)| x + correction).collect())
    }

    /// Returns the backward error with shared multipliers, and otherwise zero for an accepted solution.
    fn solve_from(
        &mut self,
        k: &SparseMatrix,
        x: &mut [f64],
        lambda: Option<&[f64]>,
    ) -> Result<f64, SingularMatrix> {
        let Self { pattern, b, .. } = self;
        for_each_chunk(b, |range, b| b.iter_mut().zip(range).for_each(|(b, at)| *b = x[pattern.unknown(at)]));
        let error = match self.shared.take() {
            None if self.verified && lambda.is_some() => {
                copy(&self.b, &mut self.x);
                self.substitute(k, false);
                Ok(0.0)
            }
            None => self.solve_plain(k).map(|()| 0.0),
            Some(mut shared) => {
                let error = self.solve_shared(k, &mut shared, lambda.unwrap_or_default());
                self.shared = Some(shared);
                error
            }
        }?;
        for_each_chunk(x, |range, x| {
            x.iter_mut().zip(range).for_each(|(x, unknown)| *x = self.x[self.pattern.position(unknown)]);
        });
        Ok(error)
    }

    /// Solves K x = `b` into `x`, by LU if LDLᵀ is not accurate enough.
    fn solve_plain(&mut self, k: &SparseMatrix) -> Result<(), SingularMatrix> {
        if self.solve_refined(k).is_err() {
            if self.lu.is_some() {
                return Err(SingularMatrix);
            }
            self.factorise_by_lu(k)?;
            self.solve_refined(k)?;
        }
        Ok(())
    }

    /// Solves K x = `b` into `x` by steps with K_ε. Returns the backward error.
    fn solve_shared(
        &mut self,
        k: &SparseMatrix,
        shared: &mut SharedMultipliers,
        lambda: &[f64],
    ) -> Result<f64, SingularMatrix> {
        shared.b.copy_from_slice(&self.b);
        shared.x.fill(0.0);
        let coordinates = self.b.len() - lambda.len();
        for &at in self.pattern.shared().iter().filter(|_| !lambda.is_empty()) {
            self.b[at] += COMPLIANCE / self.d[at].powi(2) * lambda[self.pattern.unknown(at) - coordinates];
        }
        self.solve_plain(&shared.compliant)?;
        shared.x.copy_from_slice(&self.x);
        shared.steps.restart();
        let least = if shared.is_rigid { f64::EPSILON } else { REFINE };
        let mut before = f64::INFINITY;
        for _ in 0..STEPS {
            self.b.copy_from_slice(&shared.b);
            let [residual, size] = self.residual(k);
            if residual <= least * size || residual > REDUCTION * before {
                return Ok(residual / size);
            }
            before = residual;
            shared.r.copy_from_slice(&self.r);
            self.b.copy_from_slice(&self.r);
            self.solve_plain(&shared.compliant)?;
            let Self { ldlt, pattern, x, r, .. } = self;
            r.fill(0.0);
            ldlt.subtract_product(pattern.supernodes(), k.values(), x, r);
            r.iter_mut().for_each(|r| *r = -*r);
            shared.steps.step([&self.x, &self.r], &self.d, &shared.r, &mut shared.x);
            self.x.copy_from_slice(&shared.x);
        }
        self.b.copy_from_slice(&shared.b);
        Ok(self.backward_error(k))
    }

    /// Solves for `b` into `x` with up to two steps of iterative refinement.
    fn solve_refined(&mut self, k: &SparseMatrix) -> Result<(), SingularMatrix> {
        copy(&self.b, &mut self.x);
        self.substitute(k, false);
        let mut error = self.backward_error(k);
        self.verified = error <= REFINE;
        for _ in 0..2 {
            if error <= REFINE {
                return Ok(());
            }
            self.substitute(k, true);
            for (x, r) in self.x.iter_mut().zip(&self.r) {
                *x += r;
            }
            error = self.backward_error(k);
        }
        if error <= ACCEPT { Ok(()) } else { Err(SingularMatrix) }
    }

    /// Performs forward and backward substitution of `x`, or of the residual `r`, in place.
    fn substitute(&mut self, k: &SparseMatrix, residual: bool) {
        let target = if residual { &mut self.r } else { &mut self.x };
        match &self.lu {
            Some(lu) => lu.solve(target),
            None => self.ldlt.solve(self.pattern.supernodes(), k.values(), target),
        }
    }

    /// Computes the residual r = b − K x and the backward error.
    fn backward_error(&mut self, k: &SparseMatrix) -> f64 {
        let [residual, size] = self.residual(k);
        residual / size
    }

    /// Computes the residual r = b − K x. Returns its scaled norm, which is infinite unless all numbers are finite, and that of its parts.
    fn residual(&mut self, k: &SparseMatrix) -> [f64; 2] {
        let Self { ldlt, pattern, d, b, x, r, .. } = self;
        copy(b, r);
        ldlt.subtract_product(pattern.supernodes(), k.values(), x, r);
        let error = |i: usize| if r[i].is_finite() { r[i].abs() * d[i] } else { f64::INFINITY };
        let residual = largest_of_chunks(b.len(), |range| range.map(error).fold(0.0, f64::max));
        let size = |i: usize| (b[i].abs() * d[i]).max(x[i].abs() / d[i]);
        let size = largest_of_chunks(b.len(), |range| range.map(size).fold(f64::MIN_POSITIVE, f64::max));
        [if residual < UNDERFLOW { 0.0 } else { residual }, size]
    }

    /// Factorises the full matrix by LU with pivoting.
    fn factorise_by_lu(&mut self, k: &SparseMatrix) -> Result<(), SingularMatrix> {
        self.lu = ScaledLu::new(k, self.b.len());
        if self.lu.is_some() { Ok(()) } else { Err(SingularMatrix) }
    }
}
