use std::f64::consts::TAU;

use nalgebra::DVector;

use super::krylov::{EigenError, EigenSearch, EigenSearchResult, krylov};
use super::pencil::Pencil;
use super::refinement::Refinement;
use crate::equations::{EquationsOfMotion, State};
use crate::newton::Interrupt;
use crate::sparse::SparseMatrix;

/// Natural mode of vibration about a state.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// Squared circular frequency ω², 1/time². It is exactly zero for a rigid mode and negative for an unstable state.
    pub omega_squared: f64,
    /// Mode shape x over the coordinates with xᵀ M x = 1. Its largest entry, weighted by the root of the mass, is
    /// positive.
    pub shape: Vec<f64>,
    /// Residual |(K − σM)⁻¹ (K x − ω² M x)| (ω² − σ)/|ω²| in the norm of M; for ω² = 0 without the last factor. It bounds
    /// the distance to the next eigenvalue, relative to ω².
    pub residual: f64,
}

/// Number of eigenvalues in an interval by Sylvester's law of inertia, independent of the computed modes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SturmCount {
    /// Upper end of the interval: all ω² below it are counted.
    pub below: f64,
    /// Number of negative eigenvalues of K − below · M, equal to the number of computed ω² in the interval.
    pub count: usize,
}

impl Mode {
    /// Returns the frequency ω / 2π, or `None` for an unstable mode.
    pub fn frequency(&self) -> Option<f64> {
        (self.omega_squared >= 0.0).then(|| self.omega_squared.sqrt() / TAU)
    }
}

/// Lowest modes of vibration about a state.
#[derive(Clone, Debug, PartialEq)]
pub struct EigenModes {
    /// Modes in ascending order of ω².
    pub modes: Vec<Mode>,
    /// Number of rigid modes, whose ω² is within the rounding error of xᵀ K x.
    pub rigid: usize,
    /// Verified number of modes, `None` if K − σM has no symmetric factorisation.
    pub sturm: Option<SturmCount>,
}

impl EigenModes {
    /// Largest residual.
    fn residual(&self) -> f64 {
        self.modes.iter().map(|mode| mode.residual).fold(0.0, f64::max)
    }
}

/// Residual tolerance of converged eigenpairs.
const TOLERANCE: f64 = 1e-7;
/// Number of block vectors in addition to the requested modes.
const GUARD: usize = 4;
/// Smallest number of modes in a block: those of a free body. The block then has a mode with strain, which determines the shift.
const RIGID: usize = 6;
/// Factor of the shift if it is too close to ω² = 0 for the solution of linear equations.
const FARTHER: f64 = 1e4;
/// Residual above which modes are computed again with a shift farther from zero.
const INACCURATE: f64 = 1e-4;
/// Number of blocks of the first Krylov space, which estimates the spectrum, and of the next ones.
const DEPTH: [usize; 2] = [4, 16];
/// Maximum number of restarts, each with a better shift and better vectors.
const PASSES: usize = 8;
/// Smallest gap between ω² at which eigenvalues are counted, relative to the distance to the shift.
const MIN_GAP: f64 = 1e-3;

/// Size of ω², relative to the highest, below which it does not determine the shift.
const NEGLIGIBLE: f64 = 1e-22;

/// Computes the `count` lowest modes K x + Φ_qᵀ μ = ω² M x, Φ_q x = 0 about a state, or fewer if there are no more.
///
/// K is the tangent of f + Φ_qᵀ λ in that state, including the stiffness of stresses, loads and multipliers. Gyroscopic
/// forces and damping are neglected.
///
/// Block Krylov spaces find the largest eigenvalues θ = 1/(ω² − σ) of (K − σM)⁻¹ M. The shift σ lies below all ω²,
/// which the inertia of K − σM verifies. Its distance to the lowest ω² is that of the smallest nonzero |ω²| to zero.
/// Free bodies with singular K are therefore admissible. Units and slope lengths have no effect.
///
/// The modes are corrected and ω² is computed with products K x term by term, which have less rounding error than the
/// assembled matrix ([`EquationsOfMotion::stiffness_products`]). The modes are complete: the number of ω² below the last
/// gap is compared with the inertia of K − σM, and the search is repeated with other vectors if it differs.
///
/// `matrix` is any matrix of the pattern of `eom`.
///
/// Source: Ericsson & Ruhe (1980), the spectral transformation; Grimes, Lewis & Simon (1994).
///
/// # Errors
/// If constraints are redundant, the mass is negative, the iteration does not converge, a mode is missing, or the search is
/// interrupted.
pub fn modes(
    eom: &dyn EquationsOfMotion,
    matrix: SparseMatrix,
    s: &State,
    count: usize,
    interrupt: &Interrupt,
) -> Result<EigenModes, EigenError> {
    let degrees = eom.degrees_of_freedom(s);
    let count = count.min(degrees);
    if count == 0 {
        return Ok(EigenModes { modes: Vec::new(), rigid: 0, sturm: None });
    }
    let mut pencil = Pencil::new(eom, matrix, s, interrupt)?;
    let mut search =
        EigenSearch { count, key: |theta| theta, least: 0.0, tolerance: TOLERANCE, depth: DEPTH[0] };
    // A shift far below all ω² prefers no mode, so the start vectors are independent even for a poor first shift.
    let highest = pencil.highest();
    pencil.factorise(-highest)?;
    let mut start = pencil.operator().start(count.max(RIGID) + GUARD, 0)?;
    let (mut best, mut failure): (Option<EigenModes>, _) = (None, EigenError::NotConverged);
    let farther = |shift: f64| (FARTHER * shift).max(-highest).min(shift);
    let mut shift = -100.0 * f64::EPSILON * highest;
    for pass in 0..PASSES {
        let factorised = pencil.factorise(shift).map(|found| shift = found);
        let found = match factorised.and_then(|()| krylov(&mut pencil.operator(), start.clone(), &search)) {
            Err(EigenError::Singular) => {
                (failure, shift) = (EigenError::Singular, farther(shift));
                continue;
            }
            found => found?,
        };
        let next = better_shift(&pencil, &found, shift);
        start = found.pairs.iter().map(|pair| pair.vector.clone()).collect();
        let is_complete = found.converged && found.requested == count;
        if pass > 0 && is_complete {
            let modes = finish(&mut pencil, &found, shift, degrees)?;
            if let Some(modes) = counted(&mut pencil, modes, shift)? {
                let is_better = best.as_ref().is_none_or(|best| modes.residual() < best.residual());
                let is_accurate = !is_better || modes.residual() <= INACCURATE;
                if is_better {
                    best = Some(modes);
                }
                if is_accurate {
                    break;
                }
                // The shift is too close to ω² = 0 of rigid modes.
                shift = farther(shift);
                continue;
            }
            failure = EigenError::Missed;
            pencil.factorise(shift)?;
            start.extend(pencil.operator().start(GUARD, pass as u64)?);
        }
        shift = next;
        search.depth = DEPTH[1];
    }
    best.ok_or(failure)
}

/// Returns a shift below the lowest ω², at the distance of the smallest |ω²| beyond the rounding error of the matrix.
///
/// Pairs may be rough here, so the bounds of their rounding errors do not apply.
fn better_shift(pencil: &Pencil<'_>, found: &EigenSearchResult, shift: f64) -> f64 {
    let vectors: Vec<DVector<f64>> = found.pairs.iter().map(|pair| pair.vector.clone()).collect();
    let squared = pencil.stiffness_products(&vectors).values();
    let negligible = NEGLIGIBLE * pencil.highest();
    let errors: Vec<f64> = vectors.iter().map(|x| pencil.rounding(x).max(negligible)).collect();
    // A rigid mode may exceed its own bound, which is zero for a translation of all nodes, but not that of the others.
    let is_zero = |(value, error): &(&f64, &f64)| value.abs() <= **error;
    let error = squared.iter().zip(&errors).filter(is_zero).map(|(_, error)| *error).fold(0.0, f64::max);
    let is_sure = |(value, own): &(&f64, &f64)| value.abs() > own.max(error);
    let squared: Vec<f64> = squared.iter().zip(&errors).filter(is_sure).map(|(value, _)| *value).collect();
    let lowest = squared.iter().copied().fold(0.0, f64::min);
    let nearest = squared.iter().map(|squared| squared.abs()).fold(f64::INFINITY, f64::min);
    if nearest.is_finite() { lowest - nearest } else { shift }
}

/// Computes the modes of converged pairs. Vectors beyond the number of degrees of freedom are rounding errors.
fn finish(
    pencil: &mut Pencil<'_>,
    found: &EigenSearchResult,
    shift: f64,
    degrees: usize,
) -> Result<EigenModes, EigenError> {
    // T makes x satisfy the constraints to the accuracy of the linear solver.
    let images: Result<Vec<_>, _> =
        found.pairs.iter().take(degrees).map(|pair| pencil.operator().apply(&pair.vector)).collect();
    let refined = Refinement::new(pencil, images?, found.requested, shift)?;
    let n = pencil.coordinates();
    let mode = |k: usize| {
        let x = &refined.vectors[k];
        let sign = pencil.sign(x);
        let shape = x.as_slice()[..n].iter().map(|x| sign * x).collect();
        Mode { omega_squared: refined.squared[k], shape, residual: refined.residuals[k] }
    };
    let modes: Vec<Mode> = (0..found.requested).map(mode).collect();
    let rigid = modes.iter().filter(|mode| mode.omega_squared == 0.0).count();
    Ok(EigenModes { modes, rigid, sturm: None })
}

/// Verifies the number of ω² below the last gap. Returns `None` if it differs from the number of modes there.
fn counted(pencil: &mut Pencil<'_>, modes: EigenModes, shift: f64) -> Result<Option<EigenModes>, EigenError> {
    let squared: Vec<f64> = modes.modes.iter().map(|mode| mode.omega_squared).collect();
    let has_gap = |k: &usize| squared[*k] - squared[*k - 1] > MIN_GAP * (squared[*k] - shift);
    let gap = (1..squared.len()).rev().find(has_gap);
    let (below, expected) = gap.map_or((shift, 0), |k| (0.5 * (squared[k - 1] + squared[k]), k));
    let Some(count) = pencil.count_below(below)? else { return Ok(Some(modes)) };
    let sturm = Some(SturmCount { below, count });
    Ok((count == expected).then_some(EigenModes { sturm, ..modes }))
}
