use std::f64::consts::TAU;

use nalgebra::DVector;

use super::krylov::{EigenError, EigenSearch, EigenSearchResult, Operator, krylov};
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::factor::Factor;
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
    /// Residual |T x − θ x| / θ in the norm of M, with T = (K − σM)⁻¹ M and θ = 1/(ω² − σ).
    pub residual: f64,
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
    /// Number of rigid modes, whose ω² is within the rounding error of K.
    pub rigid: usize,
}

/// Residual tolerance of converged eigenpairs.
const TOLERANCE: f64 = 1e-7;
/// Number of block vectors in addition to the requested modes.
const GUARD: usize = 4;
/// Number of blocks of the first Krylov space, which estimates the spectrum, and of the next ones.
const DEPTH: [usize; 2] = [4, 16];
/// Maximum number of restarts, each with a better shift and better vectors.
const PASSES: usize = 8;
/// Multiple of the rounding error of xᵀ K x below which ω² is zero.
const ZERO: f64 = 8.0;

/// Computes the `count` lowest modes K x + Φ_qᵀ μ = ω² M x, Φ_q x = 0 about a state, or fewer if there are no more.
///
/// K is the tangent of f + Φ_qᵀ λ in that state, including the stiffness of stresses, loads and multipliers. Gyroscopic
/// forces and damping are neglected.
///
/// Block Krylov spaces find the largest eigenvalues θ = 1/(ω² − σ) of (K − σM)⁻¹ M. The shift σ lies below all ω²,
/// which the inertia of K − σM verifies. Its distance to the lowest ω² is that of the smallest nonzero |ω²| to zero.
/// Free bodies with singular K are therefore admissible. Units and slope lengths have no effect.
///
/// `matrix` is any matrix of the pattern of `eom`.
///
/// Source: Ericsson & Ruhe (1980), the spectral transformation; Grimes, Lewis & Simon (1994).
///
/// # Errors
/// If constraints are redundant, the mass is negative, the iteration does not converge, or it is interrupted.
pub fn modes(
    eom: &dyn EquationsOfMotion,
    matrix: SparseMatrix,
    s: &State,
    count: usize,
    interrupt: &Interrupt,
) -> Result<EigenModes, EigenError> {
    let count = count.min(eom.degrees_of_freedom(s));
    if count == 0 {
        return Ok(EigenModes { modes: Vec::new(), rigid: 0 });
    }
    let mut pencil = Pencil::new(eom, matrix, s, interrupt)?;
    let mut search =
        EigenSearch { count, key: |theta| theta, least: 0.0, tolerance: TOLERANCE, depth: DEPTH[0] };
    // A shift far below all ω² prefers no mode, so the start vectors are independent even for a poor first shift.
    let highest = pencil.highest();
    pencil.factorise(-highest)?;
    let mut start = pencil.operator().start(count + GUARD)?;
    let mut shift = -100.0 * f64::EPSILON * highest;
    for pass in 0..PASSES {
        shift = pencil.factorise(shift)?;
        let found = krylov(&mut pencil.operator(), start, &search)?;
        if pass > 0 && found.converged {
            return pencil.finish(found);
        }
        shift = pencil.better_shift(&found, shift);
        start = found.pairs.into_iter().map(|pair| pair.vector).collect();
        search.depth = DEPTH[1];
    }
    Err(EigenError::NotConverged)
}

/// Matrices K and M of a state, and K − σM with its factors.
struct Pencil<'a> {
    eom: &'a dyn EquationsOfMotion,
    s: &'a State,
    stiffness: SparseMatrix,
    mass: SparseMatrix,
    shifted: SparseMatrix,
    factor: Factor,
    interrupt: &'a Interrupt,
}

impl<'a> Pencil<'a> {
    fn new(
        eom: &'a dyn EquationsOfMotion,
        matrix: SparseMatrix,
        s: &'a State,
        interrupt: &'a Interrupt,
    ) -> Result<Self, EigenError> {
        let (mut stiffness, mut mass) = (matrix.clone(), matrix.clone());
        eom.tangent(s, Weights::STIFFNESS, &mut stiffness);
        eom.tangent(s, Weights::MASS, &mut mass);
        let factor = Factor::new(matrix.pattern())?;
        Ok(Self { eom, s, stiffness, mass, shifted: matrix, factor, interrupt })
    }

    /// Estimates the highest ω² by the largest K_ii / M_ii. Returns one without stiffness.
    fn highest(&self) -> f64 {
        let ratio = |i| match self.mass.diagonal_of(i) {
            mass if mass > 0.0 => self.stiffness.diagonal_of(i).abs() / mass,
            _ => 0.0,
        };
        let highest = (0..self.eom.coordinates()).map(ratio).fold(0.0, f64::max);
        if highest > 0.0 { highest } else { 1.0 }
    }

    /// Factorises K − σM for the first of σ, 4σ, 16σ, ... below all ω². Returns this shift.
    fn factorise(&mut self, mut shift: f64) -> Result<f64, EigenError> {
        // 4¹⁰⁰ exceeds any spectrum.
        for _ in 0..100 {
            self.eom.tangent(self.s, Weights { q: 1.0, v: 0.0, a: -shift }, &mut self.shifted);
            self.factor.factorise(&self.shifted)?;
            match self.factor.negative_pivots() {
                Some(negative) if negative > self.eom.multipliers() => shift *= 4.0,
                _ => return Ok(shift),
            }
        }
        Err(EigenError::Singular)
    }

    fn operator(&mut self) -> Operator<'_> {
        let Self { eom, mass, shifted, factor, interrupt, .. } = self;
        let coordinates = eom.coordinates();
        Operator { factor, left: shifted, right: mass, inner: mass, coordinates, interrupt }
    }

    /// Computes ω² = xᵀ K x for xᵀ M x = 1, and zero within the rounding error.
    fn squared(&self, x: &DVector<f64>) -> f64 {
        let squared = x.dot(&DVector::from(self.stiffness.times(x.as_slice())));
        let rounding = f64::EPSILON * self.stiffness.magnitude(x.as_slice());
        if squared.abs() > ZERO * rounding { squared } else { 0.0 }
    }

    /// Returns a shift below the lowest ω², at the distance of the smallest nonzero |ω²|.
    fn better_shift(&self, found: &EigenSearchResult, shift: f64) -> f64 {
        let squared = found.pairs.iter().take(found.requested.max(1)).map(|pair| self.squared(&pair.vector));
        let squared: Vec<f64> = squared.filter(|&squared| squared != 0.0).collect();
        let lowest = squared.iter().copied().fold(0.0, f64::min);
        let nearest = squared.iter().map(|squared| squared.abs()).fold(f64::INFINITY, f64::min);
        if nearest.is_finite() { lowest - nearest } else { shift }
    }

    /// Computes the modes of converged pairs, with one more iteration each.
    fn finish(&mut self, found: EigenSearchResult) -> Result<EigenModes, EigenError> {
        let mut modes = Vec::with_capacity(found.requested);
        for pair in &found.pairs[..found.requested] {
            let image = self.operator().apply(&pair.vector)?;
            let rest = &image - &pair.vector * pair.value;
            let residual = self.size(&rest) / pair.value;
            let x = &image * (self.sign(&image) / self.size(&image));
            let squared = self.squared(&x);
            modes.push(Mode {
                omega_squared: squared,
                shape: x.as_slice()[..self.eom.coordinates()].to_vec(),
                residual,
            });
        }
        modes.sort_by(|a, b| a.omega_squared.total_cmp(&b.omega_squared));
        let rigid = modes.iter().filter(|mode| mode.omega_squared == 0.0).count();
        Ok(EigenModes { modes, rigid })
    }

    /// Computes √(xᵀ M x).
    fn size(&self, x: &DVector<f64>) -> f64 {
        x.dot(&DVector::from(self.mass.times(x.as_slice()))).max(0.0).sqrt()
    }

    /// Returns the sign of the first of the largest entries. Entries within a relative 10⁻⁶ count as equal.
    fn sign(&self, x: &DVector<f64>) -> f64 {
        let weighed = |i: usize| x[i] * self.mass.diagonal_of(i).abs().sqrt();
        let all = 0..self.eom.coordinates();
        let largest = all.clone().map(|i| weighed(i).abs()).fold(0.0, f64::max);
        let first = all.clone().find(|&i| weighed(i).abs() >= (1.0 - 1e-6) * largest);
        first.map_or(1.0, |i| x[i].signum())
    }
}
