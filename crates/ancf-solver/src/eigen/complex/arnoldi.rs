use faer::Mat;
use nalgebra::{Complex, DMatrix, DVector};

use crate::eigen::operator::EigenError;
use crate::vectors::PseudoRandom;

/// Operator T on real vectors, with an inner product.
pub(super) trait ArnoldiOperator {
    /// Computes T x.
    fn apply(&mut self, x: &DVector<f64>) -> Result<DVector<f64>, EigenError>;

    /// Computes B x for the inner product xᵀ B y.
    fn inner_image(&self, x: &DVector<f64>) -> DVector<f64>;

    /// Computes √(xᵀ B x).
    fn norm(&self, x: &DVector<f64>) -> f64 {
        x.dot(&self.inner_image(x)).max(0.0).sqrt()
    }
}

/// Tolerances of real and of equal eigenvalues, relative to their size.
#[derive(Clone, Copy, Debug)]
pub(super) struct PairTolerance {
    /// Imaginary part of θ below which it is zero.
    pub(super) real: f64,
    /// Difference of two θ below which their vectors are orthogonalised.
    pub(super) equal: f64,
    /// Value of θ that may be defective, such as that of rigid-body motions, and the distance, relative to it, of those that count as
    /// equal to it.
    pub(super) defective: Option<[f64; 2]>,
}

impl PairTolerance {
    /// Returns the value without a negligible imaginary part, and true if it is the defective value.
    fn rounded(&self, mut value: Complex<f64>) -> (Complex<f64>, bool) {
        if let Some([defective, distance]) = self.defective
            && (value - defective).norm() <= distance * defective.abs()
        {
            return (Complex::from(defective), true);
        }
        if value.im.abs() <= self.real * value.norm() {
            value.im = 0.0;
        }
        (value, false)
    }
}

/// Basis V, orthonormal in the inner product, and T V = V H for the columns to which T was applied.
pub(super) struct ArnoldiSpace {
    tolerance: PairTolerance,
    basis: Vec<DVector<f64>>,
    columns: Vec<Vec<f64>>,
}

/// Approximate eigenpair of T, with the vector in terms of the basis.
pub(super) struct ComplexPair {
    pub(super) value: Complex<f64>,
    pub(super) vector: Vec<Complex<f64>>,
    /// |T x − θ x| / |θ|.
    pub(super) residual: f64,
    /// True for the defective value. Vectors of all pairs but its eigenvectors have large residuals.
    pub(super) is_defective: bool,
}

/// Size of a remainder, relative to the vector, below which the vector is dependent.
const DEPENDENT: f64 = 1e-10;

impl ArnoldiSpace {
    /// Creates an empty space.
    pub(super) fn new(tolerance: PairTolerance) -> Self {
        Self { tolerance, basis: Vec::new(), columns: Vec::new() }
    }

    /// Applies T until H has a number of columns, or the space is invariant.
    pub(super) fn extend(&mut self, op: &mut impl ArnoldiOperator, columns: usize) -> Result<(), EigenError> {
        while self.columns.len() < columns && self.columns.len() < self.basis.len() {
            let image = op.apply(&self.basis[self.columns.len()])?;
            let column = self.insert(op, image);
            self.columns.push(column);
        }
        Ok(())
    }

    /// Returns the number of eigenvalues of the square part of H.
    pub(super) fn size(&self) -> usize {
        self.columns.len()
    }

    /// True if T maps the space onto itself, within rounding errors.
    pub(super) fn is_invariant(&self) -> bool {
        self.columns.len() == self.basis.len()
    }

    /// Returns real and imaginary part of an eigenvector.
    pub(super) fn vector(&self, pair: &ComplexPair) -> [DVector<f64>; 2] {
        let mut parts = [(); 2].map(|()| DVector::zeros(self.basis[0].len()));
        for (v, weight) in self.basis.iter().zip(&pair.vector) {
            parts[0].axpy(weight.re, v, 1.0);
            parts[1].axpy(weight.im, v, 1.0);
        }
        parts
    }

    /// Orthogonalises a vector, twice, and adds the remainder to the basis. Returns its coefficients.
    pub(super) fn insert(&mut self, op: &impl ArnoldiOperator, mut x: DVector<f64>) -> Vec<f64> {
        let (mut coefficients, before) = (vec![0.0; self.basis.len()], op.norm(&x));
        for _ in 0..2 {
            let image = op.inner_image(&x);
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
    pub(super) fn eigenpairs(&self, count: usize) -> Result<Vec<ComplexPair>, EigenError> {
        let n = self.columns.len();
        let entry = |i: usize, j: usize| self.columns[j].get(i).copied().unwrap_or(0.0);
        let h = DMatrix::from_fn(n, n, entry);
        let found = Mat::from_fn(n, n, entry).eigenvalues().map_err(|_| EigenError::NotConverged)?;
        let rounded = |value: &faer::c64| self.tolerance.rounded(Complex::new(value.re, value.im));
        let mut values: Vec<(Complex<f64>, bool)> = found.iter().map(rounded).collect();
        values.sort_by(|(a, _), (b, _)| b.norm().total_cmp(&a.norm()).then(b.im.total_cmp(&a.im)));
        let mut end = count.min(values.len());
        if end < values.len() && end > 0 && values[end - 1].0.im > 0.0 {
            end += 1;
        }
        let mut pairs: Vec<ComplexPair> = Vec::with_capacity(end);
        let mut null: Option<Option<NullVectors>> = None;
        for (k, &(value, is_defective)) in values[..end].iter().enumerate() {
            let equal: Vec<&[Complex<f64>]> = pairs
                .iter()
                .filter(|pair| (pair.value - value).norm() <= self.tolerance.equal * value.norm())
                .map(|pair| pair.vector.as_slice())
                .collect();
            let vector = if is_defective {
                let null = null.get_or_insert_with(|| NullVectors::new(&h, value.re));
                null.as_mut().and_then(NullVectors::next)
            } else {
                let at = |offset: &f64| eigenvector(&h, value * (1.0 + offset), k, &equal);
                OFFSETS.iter().find_map(at)
            };
            let vector = vector.ok_or(EigenError::NotConverged)?;
            let rest = |i: usize| (0..n).map(|j| vector[j] * entry(i, j)).sum::<Complex<f64>>();
            let own = |i: usize| rest(i) - value * vector[i];
            let square =
                (0..n).map(|i| own(i).norm_sqr()).chain((n..self.basis.len()).map(|i| rest(i).norm_sqr()));
            let residual = square.sum::<f64>().sqrt() / value.norm();
            pairs.push(ComplexPair { value, vector, residual, is_defective });
        }
        Ok(pairs)
    }
}

/// Distances of the shift of inverse iteration from the eigenvalue, relative to it. The matrix may be exactly singular at the first.
const OFFSETS: [f64; 2] = [1e-12, 1e-9];

/// Right singular vectors of H − θ by ascending singular values: eigenvectors of θ come first, orthogonal to each other.
struct NullVectors {
    vectors: Mat<f64>,
    left: usize,
}

impl NullVectors {
    fn new(h: &DMatrix<f64>, value: f64) -> Option<Self> {
        let n = h.nrows();
        let shifted = Mat::from_fn(n, n, |i, j| h[(i, j)] - if i == j { value } else { 0.0 });
        let vectors = shifted.svd().ok()?.V().to_owned();
        Some(Self { vectors, left: n })
    }

    fn next(&mut self) -> Option<Vec<Complex<f64>>> {
        self.left = self.left.checked_sub(1)?;
        Some(self.vectors.col(self.left).iter().map(|x| Complex::from(*x)).collect())
    }
}

/// Removes the components along other vectors, and normalises.
fn orthogonalise(x: &mut [Complex<f64>], others: &[&[Complex<f64>]]) {
    for other in others {
        let dot: Complex<f64> = other.iter().zip(x.iter()).map(|(other, x)| other.conj() * x).sum();
        x.iter_mut().zip(*other).for_each(|(x, other)| *x -= dot * other);
    }
    let size = x.iter().map(Complex::norm_sqr).sum::<f64>().sqrt();
    x.iter_mut().for_each(|x| *x /= size);
}

/// Computes an eigenvector of H next to a shift by inverse iteration, orthogonal to those of equal eigenvalues.
fn eigenvector(
    h: &DMatrix<f64>,
    shift: Complex<f64>,
    seed: usize,
    equal: &[&[Complex<f64>]],
) -> Option<Vec<Complex<f64>>> {
    let n = h.nrows();
    let shifted = DMatrix::from_fn(n, n, |i, j| {
        Complex::from(h[(i, j)]) - if i == j { shift } else { Complex::from(0.0) }
    });
    let factors = shifted.lu();
    let mut random = PseudoRandom(seed as u64 + 7);
    let mut x = DVector::from_fn(n, |_, _| Complex::from(random.number()));
    for _ in 0..4 {
        orthogonalise(x.as_mut_slice(), equal);
        x = factors.solve(&x)?;
        let size = x.norm();
        x.unscale_mut(size);
    }
    x.iter().all(|x| x.re.is_finite() && x.im.is_finite()).then(|| x.iter().copied().collect())
}
