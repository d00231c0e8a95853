use nalgebra::{Cholesky, DMatrix, DVector, SymmetricEigen};

use super::columns::Columns;
use super::krylov::{KrylovSpace, Ritz};
use super::operator::EigenError;
use super::pencil::Pencil;

/// Maximum number of corrections.
pub(super) const CORRECTIONS: usize = 40;
/// Residual below which modes are not corrected.
pub(super) const ACCURATE: f64 = 1e-9;
/// Reduction of the residual below which further corrections have no effect.
pub(super) const PROGRESS: f64 = 0.9;

/// Residual up to which the corrections alone reduce the components of other modes.
const SMALL: f64 = 1e-6;

/// Multiple of the error of the factors up to which ω² of the vectors belong to the Rayleigh-Ritz method.
const MIXED: f64 = 1000.0;
/// Multiple of the energy zᵀ (K − σM) z of the correction z of a mode up to which its ω² is zero. The error of x = x₀ + z
/// adds zᵀ K z to ω² = 0.
const ENERGIES: f64 = 4.0;
/// Size of a correction above which a mode is not accurate enough for the decision that its ω² is zero.
const UNDECIDED: f64 = 1e-6;

/// Modes, M-orthonormal, in ascending order of ω².
pub(super) struct Refinement {
    /// Values of ω², zero within the rounding error of xᵀ K x.
    pub(super) squared: Vec<f64>,
    /// Mode shapes.
    pub(super) vectors: Vec<DVector<f64>>,
    /// Relative residuals |z| (ω² − σ)/|ω²| with z = (K − σM)⁻¹ (K x − ω² M x). For ω² = 0 without the last factor, and at
    /// least √(zᵀ (K − σM) z/|σ|).
    pub(super) residuals: Vec<f64>,
    corrections: Vec<DVector<f64>>,
    /// Products of K with the vectors and with their corrections.
    products: [Vec<DVector<f64>>; 2],
}

/// Shift with the rounding error of its factors as an error of ω².
#[derive(Clone, Copy, Debug)]
pub(super) struct Accuracy {
    pub(super) shift: f64,
    pub(super) error: f64,
}

impl Refinement {
    /// Corrects the best `count` Ritz vectors of a space with the residuals of the terms, x − (K − σM)⁻¹ (K x − ω² M x), and the
    /// Rayleigh-Ritz method, until the residuals are small or no longer decrease.
    ///
    /// The factors contain the rounding error of the assembled matrix, the residuals do not. The Ritz vectors of the modes contain
    /// those of other modes by this error. Unless it is small, the Rayleigh-Ritz method therefore also has other vectors of the space:
    /// those of ω² within a multiple of this error, and at least as many as there are modes. The corrections reduce the components of
    /// the rest.
    pub(super) fn new(
        pencil: &mut Pencil<'_>,
        (space, ritz): (&KrylovSpace, &Ritz),
        count: usize,
        Accuracy { shift, error }: Accuracy,
    ) -> Result<Self, EigenError> {
        let mut best = Self::first(pencil, space.vectors(ritz, count), shift)?;
        let known = match best.largest() > SMALL {
            true => ritz.within(shift, MIXED * error).max(2 * count).min(ritz.count()),
            false => count,
        };
        let others = OtherVectors::new(pencil, space.ritz_vectors(ritz, count..known));
        for _ in 0..CORRECTIONS {
            if best.largest() <= ACCURATE {
                break;
            }
            let Some(vectors) = others.ritz(pencil, &best.corrected()) else { break };
            let next = Self::measure(pencil, vectors, &[], shift)?;
            let progress = next.largest() <= PROGRESS * best.largest();
            if next.largest() < best.largest() {
                best = next;
            }
            if !progress {
                break;
            }
        }
        best.sort();
        Ok(best)
    }

    /// Applies (K − σM)⁻¹ M, which makes the vectors satisfy the constraints to the accuracy of the linear solver.
    fn first(pencil: &mut Pencil<'_>, vectors: Vec<DVector<f64>>, shift: f64) -> Result<Self, EigenError> {
        let (mut images, mut reactions) = (Vec::new(), Vec::new());
        for x in &vectors {
            let (image, own) = pencil.operator().apply_with_reactions(x.as_slice())?;
            // K x − ω² M x has the opposite reactions.
            reactions.push(own / -pencil.size(&image));
            images.push(image);
        }
        Self::measure(pencil, images, &reactions, shift)
    }

    /// Returns the corrected vectors x − z and K (x − z).
    fn corrected(&self) -> [Vec<DVector<f64>>; 2] {
        let difference =
            |x: &[DVector<f64>], z: &[DVector<f64>]| x.iter().zip(z).map(|(x, z)| x - z).collect();
        let [of_vectors, of_corrections] = &self.products;
        [difference(&self.vectors, &self.corrections), difference(of_vectors, of_corrections)]
    }

    /// Largest residual.
    fn largest(&self) -> f64 {
        self.residuals.iter().copied().fold(0.0, f64::max)
    }

    /// Computes ω² = xᵀ K x and the corrections of vectors, which are normalised. The reactions of K x − ω² M x may be known.
    fn measure(
        pencil: &mut Pencil<'_>,
        mut vectors: Vec<DVector<f64>>,
        reactions: &[DVector<f64>],
        shift: f64,
    ) -> Result<Self, EigenError> {
        vectors.iter_mut().for_each(|x| *x /= pencil.size(x));
        let found = pencil.stiffness_products(&vectors);
        let (mut squared, mut corrections) = (found.values(), Vec::new());
        for (k, (x, product)) in vectors.iter().zip(&found.products).enumerate() {
            let rest = product - pencil.mass_times(x) * squared[k];
            corrections.push(pencil.operator().correction(x, rest, reactions.get(k))?);
        }
        let of_corrections = pencil.stiffness_products(&corrections);
        let mut residuals = Vec::new();
        for ((z, value), energy) in corrections.iter().zip(&mut squared).zip(&of_corrections.squares) {
            let size = pencil.size(z);
            let energy = energy.abs() + shift.abs() * size.powi(2);
            if value.abs() <= ENERGIES * energy && size <= UNDECIDED {
                *value = 0.0;
            }
            residuals.push(match *value {
                0.0 => size.max((energy / shift.abs()).sqrt()),
                value => size * (value - shift) / value.abs(),
            });
        }
        let products = [found.products, of_corrections.products];
        Ok(Self { squared, vectors, residuals, corrections, products })
    }

    /// Sorts the modes by ω².
    fn sort(&mut self) {
        let mut order: Vec<usize> = (0..self.squared.len()).collect();
        order.sort_by(|&a, &b| self.squared[a].total_cmp(&self.squared[b]));
        self.squared = order.iter().map(|&k| self.squared[k]).collect();
        self.residuals = order.iter().map(|&k| self.residuals[k]).collect();
        self.vectors = order.iter().map(|&k| self.vectors[k].clone()).collect();
    }
}

/// Vectors Y of a space besides those of the modes, with Yᵀ K Y and Yᵀ M Y.
struct OtherVectors {
    vectors: Columns,
    forms: DMatrix<f64>,
    gram: DMatrix<f64>,
}

/// Number of vectors of a product with K, which limits the storage.
const CHUNK: usize = 8;

impl OtherVectors {
    fn new(pencil: &Pencil<'_>, vectors: Columns) -> Self {
        let (count, rows) = (vectors.count(), vectors.rows());
        let [mut forms, mut gram] = [DMatrix::zeros(count, count), DMatrix::zeros(count, count)];
        for first in (0..count).step_by(CHUNK) {
            let chunk = vectors.range(first..count.min(first + CHUNK));
            let products = Columns::of(rows, &pencil.stiffness_products(&chunk).products);
            forms.columns_mut(first, chunk.len()).copy_from(&vectors.products(&products));
            gram.columns_mut(first, chunk.len()).copy_from(&vectors.products(&pencil.images(&chunk)));
        }
        Self { vectors, forms, gram }
    }

    /// Returns the Ritz vectors of the span of these and other vectors X with the lowest Ritz values, as many as X, for given X and K X.
    fn ritz(
        &self,
        pencil: &Pencil<'_>,
        [vectors, products]: &[Vec<DVector<f64>>; 2],
    ) -> Option<Vec<DVector<f64>>> {
        let (count, rows) = (vectors.len(), self.vectors.rows());
        let products = Columns::of(rows, products);
        let (images, vectors) = (pencil.images(vectors), Columns::of(rows, vectors));
        let bordered = |right: &Columns, own: &DMatrix<f64>| {
            let (first, mixed) = (vectors.products(right), self.vectors.products(right));
            let entry = |i: usize, j: usize| match (i.checked_sub(count), j.checked_sub(count)) {
                (None, None) => 0.5 * (first[(i, j)] + first[(j, i)]),
                (Some(i), None) => mixed[(i, j)],
                (None, Some(j)) => mixed[(j, i)],
                (Some(i), Some(j)) => 0.5 * (own[(i, j)] + own[(j, i)]),
            };
            DMatrix::from_fn(count + own.nrows(), count + own.nrows(), entry)
        };
        let (values, weights) = projected(&bordered(&products, &self.forms), &bordered(&images, &self.gram))?;
        let mut order: Vec<usize> = (0..values.len()).collect();
        order.sort_by(|&a, &b| values[a].total_cmp(&values[b]));
        let part =
            |from: usize, rows: usize| DMatrix::from_fn(rows, count, |i, k| weights[(from + i, order[k])]);
        let mut sum = vectors.combined(&part(0, count));
        sum.add(&self.vectors, &part(count, self.vectors.count()), 1.0);
        Some(sum.range(0..count))
    }
}

/// Size of a guard vector, relative to the largest vector, below which it consists of rounding errors.
const NEGLIGIBLE: f64 = 1e-6;
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
        if k >= count && whole <= NEGLIGIBLE * largest {
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
