use std::f64::consts::TAU;

use nalgebra::{Complex, DVector};

use super::arnoldi::{ArnoldiSpace, ComplexPair, PairTolerance};
use super::mass_ratios::largest_ratios;
use super::quadratic_operator::QuadraticOperator;
use crate::eigen::modes::modes;
use crate::eigen::operator::EigenError;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::newton::Interrupt;
use crate::sparse::SparseMatrix;
use crate::vectors::PseudoRandom;

/// Mode x e^{λt} of a system with damping or gyroscopic forces.
#[derive(Clone, Debug, PartialEq)]
pub struct DampedMode {
    /// Eigenvalue λ, 1/time, with Im λ ≥ 0: one mode stands for a pair of conjugate eigenvalues.
    pub eigenvalue: Complex<f64>,
    /// Real and imaginary part of the shape x over the coordinates. The motion is Re(x e^{λt}). The real part is the largest of all
    /// phases, with xᵀ M x = 1. If all phases are equally large, as in a circular whirl, the largest coordinate is real and positive.
    pub shape: [Vec<f64>; 2],
    /// Residual |T z − θ z| / |θ| in the norm of M, with θ = 1/(λ − σ).
    pub residual: f64,
}

impl DampedMode {
    /// Returns the frequency Im λ / 2π; 0 for a motion without oscillation.
    pub fn frequency(&self) -> f64 {
        self.eigenvalue.im / TAU
    }

    /// Returns the damping ratio −Re λ / |λ|; 1 for a motion that decays without oscillation, 0 for λ = 0.
    pub fn damping_ratio(&self) -> f64 {
        let size = self.eigenvalue.norm();
        // A difference, so that a motion without damping has no negative zero.
        if size > 0.0 { (0.0 - self.eigenvalue.re) / size } else { 0.0 }
    }
}

/// Damped modes of a state.
#[derive(Clone, Debug, PartialEq)]
pub struct DampedModes {
    /// Modes by ascending |λ|.
    pub modes: Vec<DampedMode>,
    /// False if fewer modes than requested converged.
    pub is_complete: bool,
}

/// Residual tolerance of converged eigenpairs.
const TOLERANCE: f64 = 1e-9;
/// Real and imaginary parts of λ below this part of |λ| are zero.
const NEGLIGIBLE: f64 = 1e-8;
/// Difference of 1/(λ − σ) below which eigenvalues count as equal, relative to their size.
const EQUAL: f64 = 1e-6;
/// Distance, relative to it, from the first eigenvalue without a vector.
const CLEARANCE: f64 = 1e-3;
/// Eigenvalues below this part of the shift are zero: the double eigenvalue of a rigid-body motion has an error of the root of ε.
const ZERO: f64 = 1e-6;
/// The same without double eigenvalues.
const SIMPLE_ZERO: f64 = 1e-10;
/// Number of start vectors in addition to those of the undamped modes.
const GUARD: usize = 4;
/// Largest number of Krylov vectors in multiples of the first one, and the factor of the enlargements.
const DEPTH: [usize; 2] = [32, 2];
/// Shift as a part of the lowest frequency.
const SHIFT: f64 = 0.3;
/// Relative difference of amplitudes that are equal, such as those of the phases of a circular whirl.
const CIRCULAR: f64 = 1e-6;

/// Computes the `count` modes (λ²M + λC + K) x + Φ_qᵀ μ = 0, Φ_q x = 0 with the smallest |λ|.
///
/// C = ∂f/∂v and K = ∂f/∂q have symmetric and skew parts, of damping, gyroscopic forces and loads without a potential. Arnoldi's
/// method finds the λ next to a real shift σ > 0. All |λ| ≤ R − σ are known if those with |λ − σ| ≤ R are. Eigenvalues that accumulate at
/// a point cannot be separated, such as those of strain damping at −1/τ; then only the modes below it are returned.
///
/// Source: Arnoldi (1951); Tisseur & Meerbergen (2001).
///
/// # Errors
/// If the shifted matrix is singular, the iteration does not converge, or it is interrupted.
pub fn damped_modes(
    eom: &dyn EquationsOfMotion,
    matrix: SparseMatrix,
    s: &State,
    count: usize,
    interrupt: &Interrupt,
) -> Result<DampedModes, EigenError> {
    let degrees = eom.degrees_of_freedom(s);
    if count == 0 || degrees == 0 {
        return Ok(DampedModes { modes: Vec::new(), is_complete: true });
    }
    let undamped = modes(eom, matrix.clone(), s, count.min(degrees), interrupt)?.modes;
    let frequencies = undamped.iter().map(|mode| mode.omega_squared.abs().sqrt()).filter(|w| *w > 0.0);
    let lowest = frequencies.fold(f64::INFINITY, f64::min);
    let shift = if lowest.is_finite() { SHIFT * lowest } else { rate_without_stiffness(eom, &matrix, s) };
    let mut op = QuadraticOperator::new(eom, matrix, s, (shift, &undamped), interrupt)?;
    // With symmetric matrices and all rigid motions at hand no double eigenvalue remains.
    let has_all = undamped.len() == degrees || undamped.iter().any(|mode| mode.omega_squared != 0.0);
    let is_simple = has_all && op.is_symmetric();
    let shift = Shift { at: shift, zero: if is_simple { SIMPLE_ZERO } else { ZERO } * shift };
    let rigid: Vec<DampedMode> = op.rigid().free().map(|x| rigid_mode(&op, x)).collect();
    let (count, degrees) = (count.saturating_sub(rigid.len()), degrees.saturating_sub(rigid.len()));
    if count == 0 || degrees == 0 {
        return Ok(DampedModes { modes: rigid, is_complete: true });
    }
    let mut random = PseudoRandom(47);
    let mut space = ArnoldiSpace::new(PairTolerance {
        real: NEGLIGIBLE,
        equal: EQUAL,
        // λ = 0: θ = −1/σ.
        defective: (!is_simple).then(|| [-shift.at.recip(), ZERO]),
    });
    let starts: Vec<DVector<f64>> = undamped.iter().filter_map(|mode| op.double(&mode.shape)).collect();
    for start in starts {
        space.insert(&op, start);
    }
    for _ in 0..GUARD {
        let start = op.start(|| random.number())?;
        space.insert(&op, start);
    }
    let first = 6 * count + 24;
    let (mut depth, mut requested) = (first, 2 * count + GUARD);
    loop {
        space.extend(&mut op, depth.min(2 * degrees))?;
        let pairs = space.eigenpairs(requested)?;
        let all = depth >= 2 * degrees || space.is_invariant();
        let is_whole = all && pairs.len() == space.size();
        let known = complete(&pairs, shift, [all, is_whole]);
        let is_blocked = pairs.iter().any(|pair| !pair.is_defective && !is_converged(pair));
        let is_complete = known.len() >= count || is_whole && !is_blocked;
        let is_last = is_whole || all && is_blocked || depth >= DEPTH[0] * first;
        if is_complete || is_last && !(known.is_empty() && rigid.is_empty()) {
            let others = known.iter().take(count).map(|pair| mode(&op, &space, pair, shift));
            let modes = rigid.into_iter().chain(others).collect();
            return Ok(DampedModes { modes, is_complete });
        }
        if is_last {
            return Err(EigenError::NotConverged);
        }
        (depth, requested) = (depth * DEPTH[1], requested * DEPTH[1]);
    }
}

/// Returns a rate for the shift of a system without stiffness: that of its damping relative to the mass.
fn rate_without_stiffness(eom: &dyn EquationsOfMotion, matrix: &SparseMatrix, s: &State) -> f64 {
    let weights = Weights::DAMPING;
    let [own, skew] = largest_ratios(eom, matrix, s, weights, &eom.skew_damping(s));
    let rate = own.max(skew);
    if rate > 0.0 { SHIFT * rate } else { 1.0 }
}

/// Shift σ, and the size of an eigenvalue that counts as zero.
#[derive(Clone, Copy, Debug)]
struct Shift {
    at: f64,
    zero: f64,
}

fn eigenvalue(pair: &ComplexPair, shift: Shift) -> Complex<f64> {
    let value = pair.value.inv() + shift.at;
    let size = value.norm();
    let rounded = |part: f64| if part.abs() <= NEGLIGIBLE * size { 0.0 } else { part };
    if size <= shift.zero {
        Complex::new(0.0, 0.0)
    } else {
        Complex::new(rounded(value.re), rounded(value.im))
    }
}

/// True for an eigenvector. A zero eigenvalue is known within [`ZERO`].
fn is_converged(pair: &ComplexPair) -> bool {
    pair.residual <= if pair.is_defective { ZERO } else { TOLERANCE }
}

/// Returns the converged pairs with Im λ ≥ 0 up to the largest |λ| below which all are known, by ascending |λ|.
///
/// A rigid-body motion without damping has a double eigenvalue 0 with one vector. The second pair is left out.
fn complete(pairs: &[ComplexPair], shift: Shift, [all, is_whole]: [bool; 2]) -> Vec<&ComplexPair> {
    let has_zero = pairs.iter().any(|pair| pair.is_defective && is_converged(pair));
    let candidates = || pairs.iter().filter(|pair| !(has_zero && pair.is_defective && !is_converged(pair)));
    let distance = |pair: &ComplexPair| pair.value.norm().recip();
    let unknown = candidates().find(|pair| !is_converged(pair));
    let known = || candidates().take_while(|pair| is_converged(pair));
    let radius = match unknown {
        None if is_whole => f64::INFINITY,
        // All eigenvalues are known in an invariant space, only their vectors may be inaccurate.
        Some(first) if all => distance(first) * (1.0 - CLEARANCE),
        _ => known().last().map_or(0.0, distance),
    };
    let size = |pair: &ComplexPair| eigenvalue(pair, shift).norm();
    let mut known: Vec<&ComplexPair> = known()
        .filter(|pair| {
            eigenvalue(pair, shift).im >= 0.0 && size(pair) <= (radius - shift.at) * (1.0 + NEGLIGIBLE)
        })
        .collect();
    known.sort_by(|a, b| size(a).total_cmp(&size(b)));
    known
}

/// Returns the mode of a pair, with the phase of [`DampedMode::shape`].
fn mode(op: &QuadraticOperator<'_>, space: &ArnoldiSpace, pair: &ComplexPair, shift: Shift) -> DampedMode {
    let n = op.coordinates();
    let [real, imaginary] = space.vector(pair).map(|part| part.rows(0, n).into_owned());
    let (sin, cos) = phase(op, &real, &imaginary).sin_cos();
    let (mut x, mut y) = (&real * cos - &imaginary * sin, &real * sin + &imaginary * cos);
    let factor = normalisation(op, &x);
    x *= factor;
    y *= factor;
    DampedMode {
        eigenvalue: eigenvalue(pair, shift),
        shape: [x.as_slice().to_vec(), y.as_slice().to_vec()],
        residual: pair.residual,
    }
}

/// Returns the mode of a rigid motion without stiffness and damping.
fn rigid_mode(op: &QuadraticOperator<'_>, shape: &DVector<f64>) -> DampedMode {
    let x = shape.rows(0, op.coordinates()).into_owned();
    let factor = normalisation(op, &x);
    let zeros = vec![0.0; x.len()];
    DampedMode {
        eigenvalue: Complex::new(0.0, 0.0),
        shape: [(x * factor).as_slice().to_vec(), zeros],
        residual: op.rigid().residual(),
    }
}

/// Returns the factor of a shape to xᵀ M x = 1 with its largest coordinate positive.
fn normalisation(op: &QuadraticOperator<'_>, x: &DVector<f64>) -> f64 {
    x[first_of_largest(x.iter().map(|x| x.abs()))].signum() / op.size(x)
}

/// Returns the phase φ at which Re(x e^{iφ}) is largest, or at which the largest coordinate is real if all are equally large.
fn phase(op: &QuadraticOperator<'_>, real: &DVector<f64>, imaginary: &DVector<f64>) -> f64 {
    // |Re(x e^{iφ})|² is largest at the phase φ of half the argument of the square sum.
    let [rr, ii, sum] = [real, imaginary, &(real + imaginary)].map(|x| op.size(x).powi(2));
    let (along, across) = (rr - ii, sum - rr - ii);
    if along.hypot(across) > CIRCULAR * (rr + ii) {
        return -0.5 * f64::atan2(across, along);
    }
    let number = first_of_largest(real.iter().zip(imaginary).map(|(x, y)| x.hypot(*y)));
    -f64::atan2(imaginary[number], real[number])
}

/// Returns the index of the first of the numbers that are the largest within rounding.
fn first_of_largest(mut numbers: impl Iterator<Item = f64> + Clone) -> usize {
    let largest = numbers.clone().fold(0.0, f64::max);
    numbers.position(|x| x >= largest * (1.0 - CIRCULAR)).unwrap_or(0)
}
