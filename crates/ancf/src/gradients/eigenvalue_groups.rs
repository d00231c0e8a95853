//! Derivatives of simple and of equal eigenvalues.

use std::ops::Range;

use nalgebra::{Cholesky, DMatrix, DVector, SymmetricEigen};

use super::differences::Derivatives;

/// Relative difference of eigenvalues up to which they are equal.
const EQUAL: f64 = 1e-6;

/// Eigenvalues θ of A x = θ B x in ascending order of their magnitude, divided into groups of equal ones.
pub(super) struct EigenvalueGroups {
    pub(super) groups: Vec<Range<usize>>,
}

impl EigenvalueGroups {
    pub(super) fn new(values: &[f64]) -> Self {
        let mut groups: Vec<Range<usize>> = Vec::new();
        for (i, value) in values.iter().enumerate() {
            match groups.last_mut() {
                Some(group) if (value - values[group.start]).abs() <= EQUAL * value.abs() => {
                    group.end = i + 1;
                }
                _ => groups.push(i..i + 1),
            }
        }
        Self { groups }
    }

    /// Pairs (i, j), i ≤ j, of each group. The squares of x_i + x_j, or of x_i for i = j, determine the forms of the group.
    fn pairs(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.groups.iter().flat_map(|group| group.clone().flat_map(|i| (i..group.end).map(move |j| (i, j))))
    }

    /// Returns the vectors whose squares are necessary, with the eigenvalue of the first one.
    pub(super) fn vectors<'a>(
        &'a self,
        vectors: &'a [DVector<f64>],
    ) -> impl Iterator<Item = (usize, DVector<f64>)> + 'a {
        self.pairs().map(|(i, j)| (i, if i == j { vectors[i].clone() } else { &vectors[i] + &vectors[j] }))
    }

    /// Computes the derivatives of the eigenvalues, and their errors, from those of the squares xᵀ (A − θ B) x and the squares xᵀ B x.
    ///
    /// Those of equal eigenvalues are the eigenvalues of the form of their vectors, in ascending order.
    pub(super) fn derivatives(&self, forms: &Derivatives, gram: &[f64]) -> Vec<[f64; 2]> {
        let mut found = Vec::new();
        let mut at = 0;
        for group in &self.groups {
            let (count, first) = (group.len(), at);
            at += count * (count + 1) / 2;
            let of_group = |squares: &[f64]| polarised(&squares[first..at], count);
            let (form, gram) = (of_group(&forms.values), of_group(gram));
            let error = forms.errors[first..at].iter().copied().fold(0.0, f64::max);
            let least = (0..count).map(|i| gram[(i, i)].abs()).fold(f64::INFINITY, f64::min);
            let values = generalised_values(&form, &gram).unwrap_or_else(|| vec![f64::NAN; count]);
            found.extend(values.into_iter().map(|value| [value, 2.0 * error / least]));
        }
        found
    }
}

/// Symmetric matrix with the given squares of the sums of vectors.
fn polarised(squares: &[f64], count: usize) -> DMatrix<f64> {
    let place = |i: usize, j: usize| i * count - i * (i + 1) / 2 + j;
    let square = |i: usize, j: usize| squares[place(i.min(j), i.max(j))];
    DMatrix::from_fn(count, count, |i, j| match i == j {
        true => square(i, i),
        false => 0.5 * (square(i, j) - square(i, i) - square(j, j)),
    })
}

/// Eigenvalues of F y = θ G y in ascending order for a definite G.
fn generalised_values(form: &DMatrix<f64>, gram: &DMatrix<f64>) -> Option<Vec<f64>> {
    let sign = gram[(0, 0)].signum();
    let lower = Cholesky::new(gram * sign)?.l();
    let half = lower.solve_lower_triangular(&(form * sign))?;
    let whole = lower.solve_lower_triangular(&half.transpose())?;
    let mut values: Vec<f64> = SymmetricEigen::new(whole).eigenvalues.iter().copied().collect();
    values.sort_by(f64::total_cmp);
    Some(values)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Equal eigenvalues of a plane form with the directions of change not along the given vectors.
    #[test]
    fn equal_eigenvalues() {
        let groups = EigenvalueGroups::new(&[1.0, 2.0, 2.0 + 1e-12, 3.0]);
        assert_eq!(groups.groups, [0..1, 1..3, 3..4]);
        // The form [2, 1; 1, 2] has the eigenvalues 1 and 3; the sum of both vectors has the square 6.
        let values = vec![5.0, 2.0, 6.0, 2.0, -1.0];
        let forms = Derivatives { others: values.clone(), values, errors: vec![0.0; 5] };
        let found = groups.derivatives(&forms, &[1.0, 1.0, 2.0, 1.0, 1.0]);
        let exact = [5.0, 1.0, 3.0, -1.0];
        found.iter().zip(exact).for_each(|([value, _], exact)| assert!((value - exact).abs() < 1e-14));
    }
}
