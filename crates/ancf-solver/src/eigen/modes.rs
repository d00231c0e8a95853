use std::f64::consts::TAU;

use super::krylov::{EigenSearch, KrylovSpace, Ritz};
use super::operator::EigenError;
use super::pencil::Pencil;
use super::refinement::{Accuracy, Refinement};
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
    /// Verified number of modes, `None` if K − σM has no symmetric factorisation, or its rounding errors exceed the gaps between ω².
    pub sturm: Option<SturmCount>,
}

impl EigenModes {
    /// Largest residual.
    fn residual(&self) -> f64 {
        self.modes.iter().map(|mode| mode.residual).fold(0.0, f64::max)
    }
}

/// Residual tolerance of converged eigenpairs.
const TOLERANCE: f64 = 1e-8;
/// Residual tolerance relative to the error of the factors.
const TOLERANCE_OF_ERROR: f64 = 1e-3;
/// Number of vectors of a block, and of those that are added after a missed mode.
const BLOCK: usize = 4;
/// Number of vectors of a space before a restart, beyond three times the number of requested modes.
const CAPACITY: usize = 300;
/// Number of vectors of large spaces beyond twice the number of requested modes.
const LEAST_CAPACITY: usize = 20;
/// Number of entries of a space above which it is large, 1 GiB.
const MAX_ENTRIES: usize = 1 << 27;
/// Memory of a search in vectors, beyond that of its space: blocks, their images, and spaces during a restart.
const WORKING_VECTORS: usize = 30;

/// Number of vectors of a space before a restart.
fn capacity(count: usize, unknowns: usize) -> usize {
    let storage = MAX_ENTRIES / unknowns.max(1);
    (2 * count + LEAST_CAPACITY).max(storage.min(3 * count + CAPACITY))
}

/// Returns the least memory of a search for modes in bytes, without matrices.
pub fn modes_memory(count: usize, unknowns: usize) -> f64 {
    let vectors = (2 * count + LEAST_CAPACITY).min(unknowns) + 4 * count + WORKING_VECTORS;
    (size_of::<f64>() * vectors) as f64 * unknowns as f64
}

/// Number of vectors for the estimate of the spectrum: more than the six rigid modes of a free body.
const ROUGH: usize = 8;
/// Number of vectors for the estimate of the rounding error of the factors.
const SAMPLE: usize = 3;
/// Number of blocks of a space from which the spectrum is estimated, and of a complete one.
const DEPTH: [usize; 2] = [4, 300];
/// Factor of the shift if it is too close to ω² = 0 for the solution of linear equations.
const FARTHER: f64 = 1e4;
/// Residual above which modes are computed again with a shift farther from zero.
const INACCURATE: f64 = 1e-4;
/// Maximum number of shifts and of searches for missed modes.
const PASSES: usize = 12;
/// Smallest gap between ω² at which eigenvalues are counted, relative to the distance to the shift, and in rounding errors of
/// the factors.
const MIN_GAP: [f64; 2] = [1e-3, 20.0];

/// Size of ω², relative to the highest, below which it does not determine the shift.
const NEGLIGIBLE: f64 = 1e-22;
/// Relative error of the factors above which they are not an approximation of K − σM.
const MAX_FACTOR_ERROR: f64 = 0.1;
/// Distance of the shift in errors of the factors.
const SAFE: f64 = 10.0;
/// Distance of the shift from the lowest ω², relative to the best one, below which it is changed.
const NEAR: f64 = 1e-3;
/// Error of the factors up to which a shift next to zero is better than a distant one.
const ACCURATE_FACTORS: f64 = 1e-6;

/// Computes the `count` lowest modes K x + Φ_qᵀ μ = ω² M x, Φ_q x = 0 about a state, or fewer if there are no more.
///
/// K is the tangent of f + Φ_qᵀ λ in that state, including the stiffness of stresses, loads and multipliers. Gyroscopic
/// forces and damping are neglected.
///
/// The block Lanczos method finds the largest eigenvalues θ = 1/(ω² − σ) of (K − σM)⁻¹ M. The shift σ lies below all ω², which the
/// inertia of K − σM verifies, at a distance above the rounding errors of the factors. Free bodies with singular K are therefore
/// admissible. Units and slope lengths have no effect.
///
/// The modes are corrected and ω² is computed with products K x by the strains of the elements, which have less rounding error
/// than the assembled matrix ([`EquationsOfMotion::stiffness_products`]). The modes are complete: the number of ω² below the last
/// gap is compared with the inertia of K − σM, and the search is continued with further vectors if it differs.
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
    let highest = pencil.highest();
    let farther = |shift: f64| (FARTHER * shift).max(-highest).min(shift);
    let (mut best, mut failure): (Option<EigenModes>, _) = (None, EigenError::NotConverged);
    let mut shift = -f64::EPSILON * highest;
    for pass in 0..PASSES {
        let search = ShiftedSearch::new(&mut pencil, shift, [count, degrees], pass);
        let found = search.and_then(|(mut search, better)| {
            shift = search.shift;
            match better.filter(|_| pass + 1 < PASSES) {
                Some(better) => Ok(Err(better)),
                None => search.complete(&mut pencil).map(Ok),
            }
        });
        let found = match found {
            Ok(Ok(found)) => found,
            Ok(Err(better)) => {
                shift = better;
                continue;
            }
            Err(error @ (EigenError::Interrupted | EigenError::Indefinite)) => return Err(error),
            Err(error) => {
                (failure, shift) = (error, farther(shift));
                continue;
            }
        };
        let is_better = best.as_ref().is_none_or(|best| found.residual() < best.residual());
        let is_accurate = !is_better || found.residual() <= INACCURATE;
        if is_better {
            best = Some(found);
        }
        if is_accurate {
            break;
        }
        // The shift is too close to ω² = 0 of rigid modes.
        shift = farther(shift);
    }
    best.ok_or(failure)
}

/// Search for the lowest modes with the factors of one shift.
struct ShiftedSearch {
    shift: f64,
    /// Number of modes, and of degrees of freedom.
    count: usize,
    search: EigenSearch,
    space: KrylovSpace,
    /// Rounding error of the factors as an error of ω².
    error: f64,
}

impl ShiftedSearch {
    /// Factorises K − σM for a shift and estimates the spectrum. Returns a better shift, if there is one.
    fn new(
        pencil: &mut Pencil<'_>,
        shift: f64,
        [count, degrees]: [usize; 2],
        pass: usize,
    ) -> Result<(Self, Option<f64>), EigenError> {
        let shift = pencil.factorise(shift)?;
        let capacity = capacity(count, pencil.unknowns());
        let search = EigenSearch { count, key: |theta| theta, least: 0.0, tolerance: TOLERANCE, capacity };
        let mut op = pencil.operator();
        let start = op.start(BLOCK, pass as u64)?;
        let mut space = KrylovSpace::new(&op, start, degrees)?;
        let rough = space.extend(&mut op, &search, [0, DEPTH[0]])?;
        let mut search = Self { shift, count, search, space, error: 0.0 };
        let better = search.better_shift(pencil, &rough)?;
        Ok((search, better))
    }

    /// Returns a shift below the lowest ω² at the distance of the smallest nonzero |ω²|, or of a multiple of the rounding error of
    /// the factors if that is larger; `None` if the shift is farther, or if neither the factors nor rigid modes require the distance.
    fn better_shift(&mut self, pencil: &mut Pencil<'_>, rough: &Ritz) -> Result<Option<f64>, EigenError> {
        let vectors = self.space.vectors(rough, ROUGH);
        let found = pencil.stiffness_products(&vectors);
        let negligible = NEGLIGIBLE * pencil.highest();
        let error = |(value, rounding): (&f64, &f64)| (*value, rounding.max(negligible));
        let squared: Vec<(f64, f64)> = found.values().iter().zip(&found.rounding).map(error).collect();
        // A rigid mode may exceed its own bound, which is zero for a translation of all nodes, but not that of the others.
        let zeros = squared.iter().filter(|(value, error)| value.abs() <= *error);
        let largest = zeros.map(|(_, error)| *error).fold(0.0, f64::max);
        let nonzero = || squared.iter().map(|(value, _)| *value).filter(|value| value.abs() > largest);
        let nearest = nonzero().map(f64::abs).fold(f64::INFINITY, f64::min);
        let lowest = nonzero().fold(0.0, f64::min);
        let bottom = squared.iter().map(|(value, _)| *value).fold(f64::INFINITY, f64::min);
        let mut relative = 0.0_f64;
        for (x, (value, _)) in vectors.iter().zip(&squared).take(SAMPLE) {
            let change = pencil.factor_error(x, self.shift)?;
            relative = relative.max(change);
            self.error = self.error.max(change * (value - self.shift));
        }
        // Vectors of the factors are not more accurate than the factors.
        self.search.tolerance = f64::max(TOLERANCE, TOLERANCE_OF_ERROR * relative);
        let distance = lowest - self.shift;
        if relative > MAX_FACTOR_ERROR {
            return Ok(Some(lowest - SAFE * self.error.max(distance)));
        }
        let best = (SAFE * self.error).max(if nearest.is_finite() { nearest } else { 0.0 });
        let is_near = relative > ACCURATE_FACTORS || bottom - self.shift < NEAR * best;
        Ok((distance < best && is_near).then_some(lowest - best))
    }

    /// Enlarges the space until all modes are found.
    fn complete(&mut self, pencil: &mut Pencil<'_>) -> Result<EigenModes, EigenError> {
        let mut least = 0;
        for pass in 0..PASSES {
            let op = &mut pencil.operator();
            let found = self.space.extend(op, &self.search, [least, DEPTH[1]])?;
            if !found.converged {
                return Err(EigenError::NotConverged);
            }
            if found.requested == self.count {
                let modes = self.finish(pencil, &found)?;
                if let Some(modes) = self.counted(pencil, modes)? {
                    return Ok(modes);
                }
                pencil.factorise(self.shift)?;
            }
            let op = &mut pencil.operator();
            let further = op.start(BLOCK, (PASSES + pass) as u64)?;
            self.space.insert(op, further)?;
            least = DEPTH[0];
        }
        Err(EigenError::Missed)
    }

    /// Computes the modes of converged pairs.
    fn finish(&self, pencil: &mut Pencil<'_>, found: &Ritz) -> Result<EigenModes, EigenError> {
        let accuracy = Accuracy { shift: self.shift, error: self.error };
        let refined = Refinement::new(pencil, (&self.space, found), self.count, accuracy)?;
        let n = pencil.coordinates();
        let mode = |k: usize| {
            let x = &refined.vectors[k];
            let sign = pencil.sign(x);
            let shape = x.as_slice()[..n].iter().map(|x| sign * x).collect();
            Mode { omega_squared: refined.squared[k], shape, residual: refined.residuals[k] }
        };
        let modes: Vec<Mode> = (0..self.count).map(mode).collect();
        let rigid = modes.iter().filter(|mode| mode.omega_squared == 0.0).count();
        Ok(EigenModes { modes, rigid, sturm: None })
    }

    /// Verifies the number of ω² below the last gap. Returns `None` if it differs from the number of modes there.
    fn counted(&self, pencil: &mut Pencil<'_>, modes: EigenModes) -> Result<Option<EigenModes>, EigenError> {
        let squared: Vec<f64> = modes.modes.iter().map(|mode| mode.omega_squared).collect();
        let [relative, errors] = MIN_GAP;
        let last_gap = |least: &dyn Fn(usize) -> f64| {
            (1..squared.len()).rev().find(|&k| squared[k] - squared[k - 1] > least(k))
        };
        let wide = |k: usize| relative * (squared[k] - self.shift);
        let gap = last_gap(&|k| wide(k).max(errors * self.error));
        if gap.is_none() && last_gap(&wide).is_some() {
            // All gaps are rounding errors of the factors.
            return Ok(Some(modes));
        }
        let (below, expected) = gap.map_or((self.shift, 0), |k| (0.5 * (squared[k - 1] + squared[k]), k));
        let Some(count) = pencil.count_below(below)? else { return Ok(Some(modes)) };
        let sturm = Some(SturmCount { below, count });
        Ok((count == expected).then_some(EigenModes { sturm, ..modes }))
    }
}
