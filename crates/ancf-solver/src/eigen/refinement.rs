use nalgebra::{Cholesky, DMatrix, DVector, SymmetricEigen};

use super::krylov::EigenError;
use super::pencil::Pencil;

/// Maximum number of corrections.
pub(super) const CORRECTIONS: usize = 40;
/// Residual below which modes are not corrected.
pub(super) const ACCURATE: f64 = 1e-9;
/// Reduction of the residual below which further corrections have no effect.
pub(super) const PROGRESS: f64 = 0.9;

/// Multiple of the energy zᵀ (K − σM) z of the correction z of a mode up to which its ω² is zero. The error of x = x₀ + z
/// adds zᵀ K z to ω² = 0.
const ENERGIES: f64 = 4.0;

/// Approximate modes, M-orthonormal, in ascending order of ω².
pub(super) struct Refinement {
    /// Values of ω², zero within the rounding error of xᵀ K x.
    pub(super) squared: Vec<f64>,
    /// Mode shapes.
    pub(super) vectors: Vec<DVector<f64>>,
    /// Relative residuals |z| (ω² − σ)/|ω²| with z = (K − σM)⁻¹ (K x − ω² M x). For ω² = 0 without the last factor, and at
    /// least √(zᵀ (K − σM) z/|σ|).
    pub(super) residuals: Vec<f64>,
    corrections: Vec<DVector<f64>>,
    forms: DMatrix<f64>,
}

impl Refinement {
    /// Corrects modes by inverse iteration with the residuals of the terms, x − (K − σM)⁻¹ (K x − ω² M x), and the
    /// Rayleigh-Ritz method, until the first `count` residuals are small or no longer decrease.
    ///
    /// The factors contain the rounding error of the assembled matrix, the residuals do not.
    pub(super) fn new(
        pencil: &mut Pencil<'_>,
        vectors: Vec<DVector<f64>>,
        count: usize,
        shift: f64,
    ) -> Result<Self, EigenError> {
        let vectors = independent(vectors, count, |x| pencil.mass_times(x));
        let mut best = Self::measure(pencil, vectors, shift)?;
        for _ in 0..CORRECTIONS {
            if best.largest(count) <= ACCURATE {
                break;
            }
            let corrected = best.vectors.iter().zip(&best.corrections).map(|(x, z)| x - z).collect();
            let rough = Self::measure(pencil, corrected, shift)?;
            let Some(vectors) = rough.ritz(pencil) else { break };
            let next = Self::measure(pencil, vectors, shift)?;
            let progress = next.largest(count) <= PROGRESS * best.largest(count);
            if next.largest(count) < best.largest(count) {
                best = next;
            }
            if !progress {
                break;
            }
        }
        best.sort(count);
        Ok(best)
    }

    /// Largest of the first residuals.
    fn largest(&self, count: usize) -> f64 {
        self.residuals.iter().take(count).copied().fold(0.0, f64::max)
    }

    /// Computes ω² = xᵀ K x and the corrections of vectors, which are normalised.
    fn measure(
        pencil: &mut Pencil<'_>,
        mut vectors: Vec<DVector<f64>>,
        shift: f64,
    ) -> Result<Self, EigenError> {
        vectors.iter_mut().for_each(|x| *x /= pencil.size(x));
        let found = pencil.stiffness_products(&vectors);
        let (mut squared, mut corrections) = (found.values(), Vec::new());
        for ((x, product), value) in vectors.iter().zip(&found.products).zip(&squared) {
            let rest = product - pencil.mass_times(x) * *value;
            corrections.push(pencil.operator().correction(x, rest)?);
        }
        let energies = pencil.stiffness_products(&corrections).forms.diagonal();
        let mut residuals = Vec::new();
        for ((z, value), energy) in corrections.iter().zip(&mut squared).zip(&energies) {
            let size = pencil.size(z);
            let energy = energy.abs() + shift.abs() * size.powi(2);
            if value.abs() <= ENERGIES * energy {
                *value = 0.0;
            }
            residuals.push(match *value {
                0.0 => size.max((energy / shift.abs()).sqrt()),
                value => size * (value - shift) / value.abs(),
            });
        }
        Ok(Self { squared, vectors, residuals, corrections, forms: found.forms })
    }

    /// Returns the Ritz vectors of the span, by ascending Ritz values.
    fn ritz(&self, pencil: &Pencil<'_>) -> Option<Vec<DVector<f64>>> {
        let count = self.vectors.len();
        let images: Vec<_> = self.vectors.iter().map(|x| pencil.mass_times(x)).collect();
        let gram = DMatrix::from_fn(count, count, |i, j| {
            0.5 * (self.vectors[i].dot(&images[j]) + self.vectors[j].dot(&images[i]))
        });
        let (values, weights) = projected(&(0.5 * (&self.forms + self.forms.transpose())), &gram)?;
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by(|&a, &b| values[a].total_cmp(&values[b]));
        Some(order.iter().map(|&k| combined(&self.vectors, weights.column(k).as_slice())).collect())
    }

    /// Sorts the first modes by ω² and removes the others, which may be inaccurate.
    fn sort(&mut self, count: usize) {
        let mut order: Vec<usize> = (0..self.squared.len().min(count)).collect();
        order.sort_by(|&a, &b| self.squared[a].total_cmp(&self.squared[b]));
        self.squared = order.iter().map(|&k| self.squared[k]).collect();
        self.residuals = order.iter().map(|&k| self.residuals[k]).collect();
        self.vectors = order.iter().map(|&k| self.vectors[k].clone()).collect();
    }
}

/// Size of a guard vector, relative to the largest vector, below which it consists of rounding errors.
const SMALL: f64 = 1e-6;
/// Size of the independent part of a guard vector below which the vector is dependent.
const DEPENDENT: f64 = 1e-3;

/// M-orthonormalises vectors. Of those after the first `count`, dependent and small ones are dropped.
pub(super) fn independent(
    vectors: Vec<DVector<f64>>,
    count: usize,
    mass_times: impl Fn(&DVector<f64>) -> DVector<f64>,
) -> Vec<DVector<f64>> {
    let size = |x: &DVector<f64>| x.dot(&mass_times(x)).max(0.0).sqrt();
    let largest = vectors.iter().map(size).fold(0.0, f64::max);
    let mut kept: Vec<(DVector<f64>, DVector<f64>)> = Vec::new();
    for (k, mut x) in vectors.into_iter().enumerate() {
        let whole = size(&x);
        if k >= count && whole <= SMALL * largest {
            continue;
        }
        x /= whole;
        for _ in 0..2 {
            for (other, image) in &kept {
                x.axpy(-x.dot(image), other, 1.0);
            }
        }
        let rest = size(&x);
        if k < count || rest > DEPENDENT {
            x /= rest;
            let image = mass_times(&x);
            kept.push((x, image));
        }
    }
    kept.into_iter().map(|(x, _)| x).collect()
}

/// Solves A w = θ B w for small symmetric A and positive definite B. Returns θ and the columns w with wᵀ B w = 1.
pub(super) fn projected(a: &DMatrix<f64>, b: &DMatrix<f64>) -> Option<(Vec<f64>, DMatrix<f64>)> {
    let root = Cholesky::new(b.clone())?.l();
    let half = root.solve_lower_triangular(a)?;
    let eigen = SymmetricEigen::new(root.solve_lower_triangular(&half.transpose())?);
    let weights = root.transpose().solve_upper_triangular(&eigen.eigenvectors)?;
    Some((eigen.eigenvalues.iter().copied().collect(), weights))
}

/// Computes a linear combination of vectors.
pub(super) fn combined(vectors: &[DVector<f64>], weights: &[f64]) -> DVector<f64> {
    let mut sum = DVector::zeros(vectors[0].len());
    vectors.iter().zip(weights).for_each(|(x, &weight)| sum.axpy(weight, x, 1.0));
    sum
}
