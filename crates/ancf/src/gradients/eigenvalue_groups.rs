//! Derivatives of simple and of equal eigenvalues.

use ancf_solver::eigen::EigenError;
use ancf_solver::factor::Factor;
use ancf_solver::sparse::SparseMatrix;
use nalgebra::{Cholesky, DMatrix, DVector, SymmetricEigen};

use super::differences::Derivatives;

/// Relative difference of eigenvalues up to which they are equal.
const EQUAL: f64 = 1e-6;

/// Least number of eigenvalues beyond the requested ones, which show whether the last ones are equal.
const FURTHER: usize = 2;

/// Groups of equal eigenvalues θ of A x = θ B x, of which some are requested. Rows are the eigenvalues of these groups.
pub(super) struct EigenvalueGroups {
    /// Numbers of the eigenvalues of the rows, in ascending order.
    pub(super) numbers: Vec<usize>,
    /// Rows of each group.
    pub(super) groups: Vec<Vec<usize>>,
    /// Number of requested rows, which are the first ones.
    pub(super) requested: usize,
    /// True if there may be further eigenvalues of a group.
    is_cut: bool,
    is_negative: Vec<bool>,
}

impl EigenvalueGroups {
    /// Groups eigenvalues by increasing magnitude, the first `requested` of which are requested.
    pub(super) fn new(values: &[f64], requested: usize) -> Self {
        let is_equal = |a: f64, b: f64| (a - b).abs() <= EQUAL * a.abs();
        let mut groups: Vec<Vec<usize>> = Vec::new();
        for (number, value) in values.iter().enumerate() {
            match groups.iter_mut().find(|group| is_equal(values[group[0]], *value)) {
                Some(group) => group.push(number),
                None if number < requested => groups.push(vec![number]),
                None => {}
            }
        }
        let mut numbers: Vec<usize> = groups.concat();
        numbers.sort_unstable();
        // The last value of each sign may have further equal ones.
        let last = |sign: bool| values.iter().rposition(|value| (*value < 0.0) == sign);
        let is_cut = [last(false), last(true)].into_iter().flatten().any(|last| numbers.contains(&last));
        let row = |number: &usize| numbers.partition_point(|own| own < number);
        let groups = groups.iter().map(|group| group.iter().map(row).collect()).collect();
        let is_negative = numbers.iter().map(|number| values[*number] < 0.0).collect();
        Self { requested: requested.min(values.len()), numbers, groups, is_cut, is_negative }
    }

    /// Searches for `count` eigenvalues and all that are equal to them. `search` finds a number of them, `group` groups them.
    pub(super) fn complete<T, E>(
        count: usize,
        mut search: impl FnMut(usize) -> Result<Vec<T>, E>,
        group: impl Fn(&[T]) -> Self,
    ) -> Result<(Vec<T>, Self), E> {
        let mut further = FURTHER;
        loop {
            let found = search(count + further)?;
            let groups = group(&found);
            if !groups.is_cut || found.len() < count + further {
                return Ok((found, groups));
            }
            further *= 4;
        }
    }

    /// Rows of each group of several eigenvalues.
    pub(super) fn equal(&self) -> impl Iterator<Item = &[usize]> {
        self.groups.iter().filter(|group| group.len() > 1).map(Vec::as_slice)
    }

    /// Pairs (i, j) of rows of each group. The squares of x_i + x_j, or of x_i for i = j, determine the forms of the group.
    fn pairs(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.groups.iter().flat_map(|group| {
            group.iter().enumerate().flat_map(|(k, i)| group[k..].iter().map(move |j| (*i, *j)))
        })
    }

    /// Returns the vectors whose squares are necessary, with the row of the first one.
    pub(super) fn vectors<'a>(
        &'a self,
        vectors: &'a [DVector<f64>],
    ) -> impl Iterator<Item = (usize, DVector<f64>)> + 'a {
        self.pairs().map(|(i, j)| (i, if i == j { vectors[i].clone() } else { &vectors[i] + &vectors[j] }))
    }

    /// Computes the derivatives of the eigenvalues of all rows, and their errors, from those of the squares xᵀ (A − θ B) x and the
    /// squares xᵀ B x.
    ///
    /// Those of equal eigenvalues are the eigenvalues of the form of their vectors, in the order of the magnitudes of the eigenvalues for
    /// an increase of the parameter.
    pub(super) fn derivatives(&self, forms: &Derivatives, gram: &[f64]) -> Vec<[f64; 2]> {
        let mut found = vec![[f64::NAN; 2]; self.numbers.len()];
        let mut at = 0;
        for group in &self.groups {
            let (count, first) = (group.len(), at);
            at += count * (count + 1) / 2;
            let of_group = |squares: &[f64]| polarised(&squares[first..at], count);
            let (form, gram) = (of_group(&forms.values), of_group(gram));
            let error: f64 = forms.errors[first..at].iter().sum();
            let least = (0..count).map(|i| gram[(i, i)].abs()).fold(f64::INFINITY, f64::min);
            let Some(mut values) = generalised_values(&form, &gram) else { continue };
            if self.is_negative[group[0]] {
                values.reverse();
            }
            for (row, value) in group.iter().zip(values) {
                found[*row] = [value, 2.0 * error / least];
            }
        }
        found
    }
}

/// Appends the reactions μ in S x + Φ_qᵀ μ = f to a shape x, given S with its factors and the force f.
pub(super) fn with_reactions(
    shape: &[f64],
    mut force: Vec<f64>,
    (matrix, factor): (&SparseMatrix, &mut Factor),
) -> Result<DVector<f64>, EigenError> {
    force[shape.len()..].fill(0.0);
    factor.solve(matrix, &mut force)?;
    force[..shape.len()].copy_from_slice(shape);
    Ok(DVector::from_vec(force))
}

/// Computes f A x over coordinates and multipliers for a shape x of coordinates.
pub(super) fn product(matrix: &SparseMatrix, shape: &[f64], factor: f64) -> Vec<f64> {
    let mut x = shape.to_vec();
    x.resize(matrix.pattern().size(), 0.0);
    let mut product = matrix.times(&x);
    product.iter_mut().for_each(|entry| *entry *= factor);
    product
}

/// Computes zᵀ A z over coordinates and multipliers.
pub(super) fn square(matrix: &SparseMatrix, z: &DVector<f64>) -> f64 {
    matrix.times(z.as_slice()).iter().zip(z).map(|(product, z)| product * z).sum()
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
        let groups = EigenvalueGroups::new(&[1.0, 2.0, 2.0 + 1e-12, 3.0], 2);
        assert_eq!(groups.groups, [vec![0], vec![1, 2]]);
        assert_eq!((groups.requested, groups.is_cut), (2, false));
        // The form [2, 1; 1, 2] has the eigenvalues 1 and 3; the sum of both vectors has the square 6.
        let values = vec![5.0, 2.0, 6.0, 2.0];
        let forms = Derivatives { others: values.clone(), values, errors: vec![0.0; 4] };
        let found = groups.derivatives(&forms, &[1.0, 1.0, 2.0, 1.0]);
        found
            .iter()
            .zip([5.0, 1.0, 3.0])
            .for_each(|([value, _], exact)| assert!((value - exact).abs() < 1e-14));
    }

    /// Eigenvalues of both signs are in groups of their own, also if they alternate. The last ones of a sign may have further equal ones.
    #[test]
    fn eigenvalues_of_both_signs() {
        let groups = EigenvalueGroups::new(&[1.0, -1.0, 1.0, -1.0, 2.0, -3.0], 2);
        assert_eq!(groups.groups, [vec![0, 2], vec![1, 3]]);
        assert!(!groups.is_cut && EigenvalueGroups::new(&[1.0, -1.0, 1.0], 1).is_cut);
        let values = vec![1.0, 1.0, 0.0, 4.0, 4.0, 0.0];
        let forms = Derivatives { others: values.clone(), values, errors: vec![0.0; 6] };
        let found = groups.derivatives(&forms, &[1.0, 2.0, 1.0, -1.0, -2.0, -1.0]);
        let exact = [0.0, 0.0, 1.0, -4.0];
        found.iter().zip(exact).for_each(|([value, _], exact)| assert!((value - exact).abs() < 1e-14));
    }
}
