//! Products with the stiffness matrix, term by term.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};

use super::term_sums::LocalState;
use super::terms::{LOCAL, LocalMatrix, State, Term, Weights};

/// Products of the stiffness matrix K with the columns of X.
#[derive(Clone, Debug)]
pub struct StiffnessProducts {
    /// Columns of K X. They have the size of the columns of X and zeros instead of multipliers.
    pub products: Vec<DVector<f64>>,
    /// Matrix Xᵀ K X.
    pub forms: DMatrix<f64>,
    /// Bounds of the rounding errors of the diagonal entries of Xᵀ K X.
    pub rounding: Vec<f64>,
}

/// Computes K X and Xᵀ K X over the coordinates, with the stiffness of each term applied to X relative to its first
/// position vector.
///
/// The entries of K of a bending element of length h grow as 1/h³, its share of xᵀ K x as h. The product of the assembled
/// matrix with a smooth x has the relative rounding error ε (L/h)⁴. Without the translation of each element the error is
/// ε (L/h)².
pub(super) fn stiffness_products(
    terms: &[Arc<dyn Term>],
    s: &State,
    x: &[DVector<f64>],
) -> StiffnessProducts {
    let mut sum = StiffnessProducts {
        products: x.iter().map(|x| DVector::zeros(x.len())).collect(),
        forms: DMatrix::zeros(x.len(), x.len()),
        rounding: vec![0.0; x.len()],
    };
    let (mut gathered, mut storage) = (LocalState::EMPTY, [0.0; LOCAL * (LOCAL + 1) / 2]);
    let mut relative = vec![[0.0; LOCAL]; x.len()];
    let mut errors = relative.clone();
    for term in terms {
        let at = gathered.gather(s, term.as_ref());
        let mut k = LocalMatrix::zero(at.q.len() + at.lambda.len(), &mut storage);
        term.tangent(&at, Weights::STIFFNESS, &mut k);
        for ((local, errors), x) in relative.iter_mut().zip(&mut errors).zip(x) {
            local.iter_mut().zip(term.coordinates()).for_each(|(local, &c)| *local = x[c]);
            errors.iter_mut().zip(&*local).for_each(|(error, x)| *error = f64::EPSILON * x.abs());
            remove_translation(term.positions(), local);
        }
        sum.add(term.coordinates(), &k, &relative, &errors);
    }
    sum
}

/// Multiple of the rounding error of a form below which it is zero.
const ZERO: f64 = 8.0;

impl StiffnessProducts {
    /// Returns the diagonal of Xᵀ K X, zero within the rounding error.
    pub fn values(&self) -> Vec<f64> {
        let value =
            |(value, rounding): (&f64, &f64)| if value.abs() > ZERO * rounding { *value } else { 0.0 };
        self.forms.diagonal().iter().zip(&self.rounding).map(value).collect()
    }

    /// Adds the products of a term, for columns with rounding errors, which the removal of the translation does not reduce.
    fn add(
        &mut self,
        coordinates: &[usize],
        k: &LocalMatrix<'_>,
        relative: &[[f64; LOCAL]],
        errors: &[[f64; LOCAL]],
    ) {
        let n = coordinates.len();
        for (at, (x, errors)) in relative.iter().zip(errors).enumerate() {
            let (mut product, mut magnitude) = ([0.0; LOCAL], [0.0; LOCAL]);
            let mut error = [0.0; LOCAL];
            for j in 0..n {
                for i in j..n {
                    let entry = k.get(i, j);
                    product[i] += entry * x[j];
                    magnitude[i] += (entry * x[j]).abs();
                    error[i] += entry.abs() * errors[j];
                    if i != j {
                        product[j] += entry * x[i];
                        magnitude[j] += (entry * x[i]).abs();
                        error[j] += entry.abs() * errors[i];
                    }
                }
            }
            coordinates.iter().zip(product).for_each(|(&c, product)| self.products[at][c] += product);
            // Of the products, and of the columns in xᵀ K x.
            let of =
                |i: usize| x[i].abs() * (f64::EPSILON * magnitude[i] + 2.0 * error[i]) + errors[i] * error[i];
            self.rounding[at] += (0..n).map(of).sum::<f64>();
            for (other, x) in relative.iter().enumerate() {
                self.forms[(other, at)] +=
                    x[..n].iter().zip(product).map(|(x, product)| x * product).sum::<f64>();
            }
        }
    }
}

/// Subtracts the first position vector from all position vectors.
fn remove_translation(positions: &[usize], x: &mut [f64]) {
    let Some(&first) = positions.first() else { return };
    let base = [x[first], x[first + 1], x[first + 2]];
    for &position in positions {
        x[position..position + 3].iter_mut().zip(base).for_each(|(x, base)| *x -= base);
    }
}
