use crate::estimate::{HalvedModel, MeshComparison};
use crate::model::Model;
use crate::simulate::run::AnalysisRun;

impl AnalysisRun<'_> {
    /// Estimates the errors of eigenvalues of a model with shells on request. Returns them relative to the eigenvalues, NaN if they are
    /// not known.
    ///
    /// `solution` returns the eigenvalues on a mesh with elements of half the size. `obstacle` is a reason for which there are none.
    pub(super) fn compare_eigenvalues(
        &mut self,
        model: &Model,
        (column, given): (&str, &[f64]),
        obstacle: Option<&str>,
        solution: impl FnOnce(&HalvedModel) -> Result<Vec<f64>, String>,
    ) -> Vec<f64> {
        let unknown = vec![f64::NAN; given.len()];
        if !model.output.errors || given.is_empty() {
            return unknown;
        }
        let comparison = MeshComparison::new(model, self.assembly, self.summary.scales);
        let found = match comparison.obstacle().or(obstacle) {
            Some(reason) => Err(reason.to_owned()),
            None => HalvedModel::new(model).and_then(|halved| Ok((solution(&halved)?, halved))),
        };
        let (errors, relative) = match found {
            Ok((fine, halved)) => comparison.eigenvalues(column, given, (&halved, &fine)),
            Err(reason) => (comparison.unknown(reason), unknown),
        };
        self.summary.warnings.extend(errors.warning());
        self.summary.errors = Some(errors);
        relative
    }
}

/// Returns for each given factor that of the same sign and rank among others by increasing magnitude; NaN if there is none.
pub(super) fn of_equal_signs(given: &[f64], others: &[f64]) -> Vec<f64> {
    let rank = |k: usize| given[..k].iter().filter(|x| x.signum() == given[k].signum()).count();
    let other = |k: usize| others.iter().filter(|x| x.signum() == given[k].signum()).nth(rank(k)).copied();
    (0..given.len()).map(|k| other(k).unwrap_or(f64::NAN)).collect()
}

#[cfg(test)]
mod tests {
    use super::of_equal_signs;

    #[test]
    fn factors_are_compared_with_those_of_the_same_sign() {
        let found = of_equal_signs(&[1.0, -1.1, 2.0, -3.0], &[-0.9, 0.95, -2.5, -2.8]);
        assert_eq!(found[..2], [0.95, -0.9]);
        assert!(found[2].is_nan() && found[3] == -2.5);
    }
}
