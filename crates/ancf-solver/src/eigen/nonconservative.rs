use faer::Mat;
use nalgebra::{Complex, DMatrix, DVector};

use super::modes::modes;
use super::operator::{EigenError, PseudoRandom};
use super::skew_operator::SkewOperator;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::newton::Interrupt;
use crate::sparse::SparseMatrix;

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
/// Imaginary part of θ, relative to its size, below which it is zero. Double eigenvalues of a matrix that is not
/// symmetric have errors of the root of ε.
const REAL: f64 = 1e-6;

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
    let mut space = ArnoldiSpace { basis: Vec::new(), columns: Vec::new() };
    for x in start.into_iter().chain(random) {
        space.insert(&op, x);
    }
    let first = 4 * count + 24;
    let mut depth = first;
    loop {
        while space.columns.len() < depth.min(degrees) && space.columns.len() < space.basis.len() {
            let image = op.apply(&space.basis[space.columns.len()])?;
            let column = space.insert(&op, image);
            space.columns.push(column);
        }
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
    let (mut mass, mut stiffness) = (matrix.clone(), matrix.clone());
    eom.tangent(s, Weights::MASS, &mut mass);
    eom.tangent(s, Weights::STIFFNESS, &mut stiffness);
    let ratio = |value: f64, i: usize, j: usize| {
        let mass = (mass.diagonal_of(i) * mass.diagonal_of(j)).sqrt();
        if mass > 0.0 { value.abs() / mass } else { 0.0 }
    };
    let highest = (0..eom.coordinates()).map(|i| ratio(stiffness.diagonal_of(i), i, i)).fold(0.0, f64::max);
    let skew = eom.skew_stiffness(s).into_iter().map(|(i, j, value)| ratio(value, i, j)).fold(0.0, f64::max);
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
        let mut x = DVector::zeros(space.basis[0].len());
        for (v, weight) in space.basis.iter().zip(&pair.vector) {
            x.axpy(if omega_squared.im < 0.0 { weight.im } else { weight.re }, v, 1.0);
        }
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

/// Basis V, orthonormal in the norm of M, and T V = V H for the columns to which T was applied.
struct ArnoldiSpace {
    basis: Vec<DVector<f64>>,
    columns: Vec<Vec<f64>>,
}

/// Approximate eigenpair of T, with the vector in terms of the basis.
struct ComplexPair {
    value: Complex<f64>,
    vector: Vec<Complex<f64>>,
    residual: f64,
}

/// Size of a remainder, relative to the vector, below which the vector is dependent.
const DEPENDENT: f64 = 1e-10;

impl ArnoldiSpace {
    /// Orthogonalises a vector, twice, and adds the remainder to the basis. Returns its coefficients.
    fn insert(&mut self, op: &SkewOperator<'_>, mut x: DVector<f64>) -> Vec<f64> {
        let (mut coefficients, before) = (vec![0.0; self.basis.len()], op.norm(&x));
        for _ in 0..2 {
            let image = op.mass_times(&x);
            for (sum, v) in coefficients.iter_mut().zip(&self.basis) {
                let dot = v.dot(&image);
                x.axpy(-dot, v, 1.0);
                *sum += dot;
            }
        }
        let size = op.norm(&x);
        if size > DEPENDENT * before {
            self.basis.push(x / size);
            coefficients.push(size);
        }
        coefficients
    }

    /// Computes the eigenpairs of the square part of H with the largest |θ|: `count` of them, and one more rather than
    /// half a conjugate pair.
    fn eigenpairs(&self, count: usize) -> Result<Vec<ComplexPair>, EigenError> {
        let n = self.columns.len();
        let entry = |i: usize, j: usize| self.columns[j].get(i).copied().unwrap_or(0.0);
        let h = DMatrix::from_fn(n, n, entry);
        let found = Mat::from_fn(n, n, entry).eigenvalues().map_err(|_| EigenError::NotConverged)?;
        let mut values: Vec<Complex<f64>> =
            found.into_iter().map(|value| Complex::new(value.re, value.im)).collect();
        for value in &mut values {
            if value.im.abs() <= REAL * value.norm() {
                value.im = 0.0;
            }
        }
        values.sort_by(|a, b| b.norm().total_cmp(&a.norm()).then(b.im.total_cmp(&a.im)));
        let mut end = count.min(values.len());
        if end < values.len() && end > 0 && values[end - 1].im > 0.0 {
            end += 1;
        }
        let mut pairs: Vec<ComplexPair> = Vec::with_capacity(end);
        for (k, &value) in values[..end].iter().enumerate() {
            let equal: Vec<&[Complex<f64>]> = pairs
                .iter()
                .filter(|pair| (pair.value - value).norm() <= REAL * value.norm())
                .map(|pair| pair.vector.as_slice())
                .collect();
            let vector = eigenvector(&h, value, k, &equal).ok_or(EigenError::NotConverged)?;
            let rest = |i: usize| (0..n).map(|j| vector[j] * entry(i, j)).sum::<Complex<f64>>();
            let own = |i: usize| rest(i) - value * vector[i];
            let square =
                (0..n).map(|i| own(i).norm_sqr()).chain((n..self.basis.len()).map(|i| rest(i).norm_sqr()));
            let residual = square.sum::<f64>().sqrt() / value.norm();
            pairs.push(ComplexPair { value, vector, residual });
        }
        Ok(pairs)
    }
}

/// Computes an eigenvector of H by inverse iteration, orthogonal to those of equal eigenvalues.
fn eigenvector(
    h: &DMatrix<f64>,
    value: Complex<f64>,
    seed: usize,
    equal: &[&[Complex<f64>]],
) -> Option<Vec<Complex<f64>>> {
    let n = h.nrows();
    let shift = value * (1.0 + 1e-9);
    let shifted = DMatrix::from_fn(n, n, |i, j| {
        Complex::from(h[(i, j)]) - if i == j { shift } else { Complex::from(0.0) }
    });
    let factors = shifted.lu();
    let mut random = PseudoRandom(seed as u64 + 7);
    let mut x = DVector::from_fn(n, |_, _| Complex::from(random.number()));
    for _ in 0..4 {
        for other in equal {
            let dot: Complex<f64> = other.iter().zip(x.iter()).map(|(other, x)| other.conj() * x).sum();
            x.iter_mut().zip(*other).for_each(|(x, other)| *x -= dot * other);
        }
        let size = x.norm();
        x.unscale_mut(size);
        x = factors.solve(&x)?;
        let size = x.norm();
        x.unscale_mut(size);
    }
    x.iter().all(|x| x.re.is_finite() && x.im.is_finite()).then(|| x.iter().copied().collect())
}
