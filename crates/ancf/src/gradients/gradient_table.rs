use nalgebra::DMatrix;

use crate::errors::short;
use crate::units::Dimension;

/// Derivatives of results with respect to numbers of a model, in the user's units.
#[derive(Clone, Debug)]
pub struct Gradients {
    /// Names of the results: columns of statics, `frequency[0]` ... of modes, `factor[0]` ... of buckling.
    pub quantities: Vec<String>,
    /// Values of the results.
    pub values: Vec<f64>,
    /// Paths of the parameters.
    pub parameters: Vec<String>,
    /// Values of the parameters.
    pub parameter_values: Vec<f64>,
    /// Derivatives, one row for each result and one column for each parameter.
    pub derivatives: DMatrix<f64>,
    /// Estimated numerical errors of the derivatives, without that of the mesh.
    pub errors: DMatrix<f64>,
    /// Restrictions of the validity.
    pub warnings: Vec<String>,
    /// Dimensions of the results.
    pub(super) dimensions: Vec<Option<Dimension>>,
}

/// Error of a derivative above which it is not accurate, relative to the largest one of the results of its dimension.
const INACCURATE: f64 = 1e-4;
/// Relative difference of the derivatives of equal eigenvalues above which they differ.
const DIFFERENT: f64 = 1e-6;
/// Part of the ratio of a result and the parameter that counts as its derivative.
const LEAST: f64 = 0.1;

impl Gradients {
    /// Replaces the derivatives with respect to a parameter by those with smaller errors, or all of them unless they are known.
    pub(super) fn improve(&mut self, column: usize, derivatives: &[[f64; 2]], is_known: bool) {
        for (row, [value, error]) in derivatives.iter().enumerate() {
            if !is_known || *error < self.errors[(row, column)] {
                self.derivatives[(row, column)] = *value;
                self.errors[(row, column)] = *error;
            }
        }
    }

    /// Keeps the first results.
    pub(super) fn truncate(&mut self, count: usize) {
        let rows = self.quantities.len().saturating_sub(count);
        self.quantities.truncate(count);
        self.values.truncate(count);
        self.dimensions.truncate(count);
        for table in [&mut self.derivatives, &mut self.errors] {
            *table = std::mem::take(table).remove_rows(count, rows);
        }
    }

    /// Warns of equal eigenvalues whose derivatives differ.
    pub(super) fn warn_of_equal<'a>(&mut self, groups: impl Iterator<Item = &'a [usize]>) {
        for group in groups {
            let spread = |column: usize| {
                let of_group = || group.iter().map(|&row| self.derivatives[(row, column)]);
                let largest = of_group().map(f64::abs).fold(0.0, f64::max);
                let first = self.derivatives[(group[0], column)];
                of_group().any(|x| (x - first).abs() > DIFFERENT * largest)
            };
            if (0..self.parameters.len()).any(spread) {
                let names: Vec<String> =
                    group.iter().map(|&row| format!("`{}`", self.quantities[row])).collect();
                self.warnings.push(format!(
                    "{} are equal: their derivatives, in the order of the results for an increase, hold for the change of one parameter, and only \
                     the sums over these results hold for the change of several ones",
                    names.join(", ")
                ));
            }
        }
    }

    /// Warning of derivatives with respect to a parameter that are not accurate.
    pub(super) fn inaccurate(&self, column: usize) -> Option<String> {
        let rows = 0..self.quantities.len();
        let size = |row: usize| {
            let relative = LEAST * self.values[row].abs() / self.parameter_values[column].abs();
            let relative = if relative.is_finite() { relative } else { 0.0 };
            self.derivatives[(row, column)].abs().max(relative)
        };
        let largest = |of: usize| {
            // Eigenvalues have no dimension here: each has its own size.
            let is_equal = |row: &usize| {
                *row == of || self.dimensions[of].is_some_and(|own| self.dimensions[*row] == Some(own))
            };
            let equal = rows.clone().filter(is_equal);
            equal.map(size).fold(0.0, f64::max)
        };
        let is_inaccurate = |row: &usize| {
            let (error, largest) = (self.errors[(*row, column)], largest(*row));
            let is_unknown = error.is_nan() || self.derivatives[(*row, column)].is_nan();
            is_unknown || (largest > 0.0 && error > INACCURATE * largest)
        };
        let worst: Vec<usize> = rows.clone().filter(is_inaccurate).collect();
        let first = *worst.first()?;
        Some(format!(
            "{} derivatives with respect to `{}` are not accurate, such as that of `{}`: {} with an estimated error of {}",
            worst.len(),
            self.parameters[column],
            self.quantities[first],
            short(self.derivatives[(first, column)]),
            short(self.errors[(first, column)])
        ))
    }
}
