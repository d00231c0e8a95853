use nalgebra::{Complex, DVector};

use super::arnoldi::{ArnoldiOperator, ArnoldiSpace, ComplexPair, PairTolerance};
use super::mass_ratios::largest_ratios;
use super::skew_operator::SkewOperator;
use crate::eigen::modes::modes;
use crate::eigen::operator::EigenError;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::newton::Interrupt;
use crate::sparse::SparseMatrix;
use crate::vectors::PseudoRandom;

/// Mode of vibration under loads without a potential.
#[derive(Clone, Debug, PartialEq)]
pub struct ComplexMode {
    /// Squared circular frequency ω², 1/time². The motion e^{iωt} is stable if ω² is real and not negative. Complex ω²
    /// appear in conjugate pairs: one motion of the pair grows (flutter).
    pub omega_squared: Complex<f64>,
    /// Real or imaginary part x of the shape over the coordinates with xᵀ M x = 1.
    pub shape: Vec<f64>,
    /// Residual |T x − θ x| / |θ| in the norm of M, with T = (K − σM)⁻¹ M and θ = 1/(ω² − σ).
    pub residual: f64,
}

impl ComplexMode {
    /// Returns the frequency Re ω / 2π and the growth rate |Im ω|.
    pub fn frequency_and_growth(&self) -> [f64; 2] {
        let omega = self.omega_squared.sqrt();
        [omega.re.abs() / std::f64::consts::TAU, omega.im.abs()]
    }

    /// Returns true if an amplitude grows: ω² is negative or complex.
    pub fn is_unstable(&self) -> bool {
        self.omega_squared.im != 0.0 || self.omega_squared.re < 0.0
    }
}

/// Residual tolerance of converged eigenpairs.
const TOLERANCE: f64 = 1e-7;
/// Number of block vectors in addition to the requested modes.
const GUARD: usize = 4;
/// Largest number of Krylov vectors in multiples of the first one, and the factor of the enlargements.
const DEPTH: [usize; 2] = [16, 2];
/// Double eigenvalues of a matrix that is not symmetric have errors of the root of ε.
const PAIRS: PairTolerance = PairTolerance { real: 1e-6, equal: 1e-6, defective: None };

/// Computes the `count` modes (K + A) x + Φ_qᵀ μ = ω² M x, Φ_q x = 0 about a state with the lowest Re ω².
///
/// A is the skew part of the stiffness ([`EquationsOfMotion::skew_stiffness`]). The modes without A provide a shift σ.
/// Arnoldi's method with full orthogonalisation in the norm of M finds the largest 1/(ω² − σ).
///
/// Source: Arnoldi (1951); Saad (2011), chapter 6; Bolotin (1963) for the theory.
///
/// # Errors
/// If constraints are redundant, A has too many coordinates, the iteration does not converge, or it is interrupted.
pub fn nonconservative_modes(
    eom: &dyn EquationsOfMotion,
    matrix: SparseMatrix,
    s: &State,
    count: usize,
    interrupt: &Interrupt,
) -> Result<Vec<ComplexMode>, EigenError> {
    let degrees = eom.degrees_of_freedom(s);
    let count = count.min(degrees);
    if count == 0 {
        return Ok(Vec::new());
    }
    let symmetric = modes(eom, matrix.clone(), s, count, interrupt)?.modes;
    let squared = || symmetric.iter().map(|mode| mode.omega_squared).filter(|squared| *squared != 0.0);
    let nearest = squared().map(f64::abs).fold(f64::INFINITY, f64::min);
    let distance = if nearest.is_finite() { nearest } else { distance_of_free_bodies(eom, &matrix, s) };
    let shift = squared().fold(0.0, f64::min) - distance;
    let mut op = SkewOperator::new(eom, matrix, s, shift, interrupt)?;
    let mut random = PseudoRandom(31);
    let start: Vec<DVector<f64>> =
        symmetric.iter().map(|mode| DVector::from_vec(mode.shape.clone())).collect();
    let random = (0..GUARD).map(|_| op.start(&mut random)).collect::<Result<Vec<_>, _>>()?;
    let mut space = ArnoldiSpace::new(PAIRS);
    for x in start.into_iter().chain(random) {
        space.insert(&op, x);
    }
    let first = 4 * count + 24;
    let mut depth = first;
    loop {
        space.extend(&mut op, depth.min(degrees))?;
        let found = space.eigenpairs(count)?;
        if found.iter().all(|pair| pair.residual <= TOLERANCE) {
            return Ok(finish(&op, &space, &found, shift));
        }
        if depth >= DEPTH[0] * first || depth >= degrees {
            return Err(EigenError::NotConverged);
        }
        depth *= DEPTH[1];
    }
}

/// Smallest distance of the shift from zero, relative to the highest ω². The rounding error of ω² = 0 is far below it.
const DISTANCE: f64 = 1e-8;

/// Returns a distance of the shift from zero if all ω² without A are zero: the size of A relative to the mass.
fn distance_of_free_bodies(eom: &dyn EquationsOfMotion, matrix: &SparseMatrix, s: &State) -> f64 {
    let [highest, skew] = largest_ratios(eom, matrix, s, Weights::STIFFNESS, &eom.skew_stiffness(s));
    let distance = skew.max(DISTANCE * highest);
    if distance > 0.0 { distance } else { 1.0 }
}

/// Returns the modes of eigenpairs, by ascending Re ω². Conjugate pairs have the real and the imaginary part.
fn finish(
    op: &SkewOperator<'_>,
    space: &ArnoldiSpace,
    found: &[ComplexPair],
    shift: f64,
) -> Vec<ComplexMode> {
    let mode = |pair: &ComplexPair| {
        let omega_squared = pair.value.inv() + shift;
        let [real, imaginary] = space.vector(pair);
        let x = if omega_squared.im < 0.0 { imaginary } else { real };
        let size = op.norm(&x);
        let largest = x.iter().fold(0.0_f64, |largest, x| if x.abs() > largest.abs() { *x } else { largest });
        let shape = x.iter().map(|x| x / size * largest.signum()).collect();
        ComplexMode { omega_squared, shape, residual: pair.residual }
    };
    let mut modes: Vec<ComplexMode> = found.iter().map(mode).collect();
    modes.sort_by(|a, b| {
        let [a, b] = [a, b].map(|mode| mode.omega_squared);
        a.re.total_cmp(&b.re).then(b.im.total_cmp(&a.im))
    });
    modes
}
