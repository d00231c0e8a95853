use nalgebra::{DMatrix, DVector};

use crate::eigen::operator::EigenError;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::factor::{Factor, add_skew_product, is_zero_on_motions};
use crate::sparse::SparseMatrix;
use crate::vectors::PseudoRandom;

/// Largest dimension of the Krylov space.
const LARGEST: usize = 200;
/// Relative change of the result, in each of several steps, at which it is accepted.
const TOLERANCE: f64 = 1e-4;
const STEPS: usize = 4;
/// Squared norm of a new vector, relative to that before orthogonalisation, below which the space is invariant.
const INVARIANT: f64 = 1e-20;

/// Computes the largest ratio |x̄ᵀ A x| / x̄ᵀ K x over complex x with Φ_q x = 0, for a K that is positive definite there and the skew
/// part A of the stiffness.
///
/// It bounds |Im ω²|/Re ω² of all modes of K + A (Bendixson 1902), and is the spectral radius of B = K⁻¹A. B is skew in the inner
/// product of K. Lanczos's method with full orthogonalisation finds the radius from below, to about 1e-4. The result is zero if the
/// constraints leave nothing of A, as those of planes of symmetry do with a pressure: yᵀ A w is then a rounding error for random
/// solutions y and w.
///
/// Source: Lanczos (1950); Paige (1974) for skew matrices.
///
/// # Errors
/// If K is singular or found to be indefinite, or if the radius does not converge.
pub fn skew_ratio(eom: &dyn EquationsOfMotion, matrix: SparseMatrix, s: &State) -> Result<f64, EigenError> {
    let mut left = matrix;
    eom.tangent(s, Weights::STIFFNESS, &mut left);
    let mut factor = Factor::new(left.pattern())?;
    factor.factorise(&left)?;
    let (entries, n) = (eom.skew_stiffness(s), eom.coordinates());
    if is_zero_on_motions(&entries, n, &left, &mut factor)? {
        return Ok(0.0);
    }
    let mut random = PseudoRandom(31);
    let mut solve = |force: &DVector<f64>| -> Result<DVector<f64>, EigenError> {
        let mut x = force.as_slice().to_vec();
        x.resize(left.pattern().size(), 0.0);
        factor.solve(&left, &mut x)?;
        x.truncate(n);
        Ok(x.into())
    };
    let mut force = DVector::zeros(n);
    for &(i, j, value) in &entries {
        force[i] += value * random.number();
        force[j] += value * random.number();
    }
    // Vectors v of norm 1 with their forces K v.
    let mut space: Vec<[DVector<f64>; 2]> = Vec::new();
    let (mut columns, mut radius, mut accepted): (Vec<Vec<f64>>, f64, usize) = (Vec::new(), 0.0, 0);
    let mut vector = solve(&force)?;
    loop {
        let before = vector.dot(&force);
        let mut column = vec![0.0; space.len()];
        // Twice is enough (Kahan and Parlett, in Parlett 1980).
        for _ in 0..2 {
            for ([own, own_force], sum) in space.iter().zip(&mut column) {
                let part = own.dot(&force);
                vector.axpy(-part, own, 1.0);
                force.axpy(-part, own_force, 1.0);
                *sum += part;
            }
        }
        let square = vector.dot(&force);
        if before < 0.0 || square < -INVARIANT * before {
            return Err(EigenError::Indefinite);
        }
        if !space.is_empty() {
            columns.push(column);
            let found = spectral_radius(&columns);
            accepted = if (found - radius).abs() <= TOLERANCE * found { accepted + 1 } else { 0 };
            radius = found;
        }
        if square <= INVARIANT * before || accepted >= STEPS {
            return Ok(radius);
        }
        if space.len() >= LARGEST {
            return Err(EigenError::NotConverged);
        }
        let scale = square.sqrt().recip();
        let (next, next_force) = (&vector * scale, &force * scale);
        force = skew_product(&entries, &next);
        space.push([next, next_force]);
        vector = solve(&force)?;
    }
}

/// Computes A x.
fn skew_product(entries: &[(usize, usize, f64)], x: &DVector<f64>) -> DVector<f64> {
    let mut product = DVector::zeros(x.len());
    add_skew_product(entries, x.as_slice(), product.as_mut_slice());
    product
}

/// Returns the spectral radius of a skew matrix, given the columns of its upper triangle with the diagonal.
fn spectral_radius(columns: &[Vec<f64>]) -> f64 {
    let m = columns.len();
    let upper = DMatrix::from_fn(m, m, |i, j| columns[j].get(i).copied().unwrap_or(0.0));
    let skew = &upper - upper.transpose();
    (skew.transpose() * &skew).symmetric_eigenvalues().max().max(0.0).sqrt()
}
