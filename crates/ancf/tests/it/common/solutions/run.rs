//! Runs of models, recorded in memory.

use ancf::record::Series;
use ancf::{Model, Summary, simulate};
use nalgebra::Vector3;

/// Columns with quantities of the solution procedure, in units of the solver.
pub(crate) const SOLVER_COLUMNS: [&str; 4] = ["iterations", "residual", "increment", "drift"];

/// Completed run.
pub(crate) struct Run {
    pub(crate) summary: Summary,
    series: Series,
}

impl Run {
    /// Runs a model and asserts that the run is completed.
    pub(crate) fn of(model: &Model) -> Self {
        let mut series = Series::new();
        let summary = simulate(model, &mut series).unwrap();
        assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
        Self { summary, series }
    }

    /// Returns a column by its name.
    pub(crate) fn column(&self, name: &str) -> &[f64] {
        self.series.column(name).unwrap_or_else(|| panic!("no column {name}"))
    }

    /// Returns all columns with their names.
    pub(crate) fn columns(&self) -> impl Iterator<Item = (&str, &[f64])> {
        self.series.columns()
    }

    /// Returns the vectors with the components `name.x`, `name.y` and `name.z`, where `name.` may end in `v`, `a`, `f` or `m`.
    pub(crate) fn vectors(&self, name: &str) -> Vec<Vector3<f64>> {
        let [x, y, z] = ["x", "y", "z"].map(|axis| self.column(&format!("{name}{axis}")));
        x.iter().zip(y).zip(z).map(|((&x, &y), &z)| Vector3::new(x, y, z)).collect()
    }

    /// Returns the last value of a column.
    pub(crate) fn last(&self, name: &str) -> f64 {
        *self.column(name).last().unwrap()
    }

    /// Returns the last vector of [`Run::vectors`].
    pub(crate) fn last_vector(&self, name: &str) -> Vector3<f64> {
        *self.vectors(name).last().unwrap()
    }

    /// Returns the largest magnitude in a column.
    pub(crate) fn largest(&self, name: &str) -> f64 {
        self.column(name).iter().fold(0.0, |largest, x| x.abs().max(largest))
    }

    /// Returns the error of the energy balance, relative to the largest energy.
    pub(crate) fn energy_error(&self) -> f64 {
        let energies = ["kinetic", "strain", "potential"].map(|column| self.largest(column));
        self.largest("balance") / energies.into_iter().fold(0.0, f64::max)
    }
}

/// Returns the largest distance of two histories of vectors.
pub(crate) fn distance(a: &[Vector3<f64>], b: &[Vector3<f64>]) -> f64 {
    assert_eq!(a.len(), b.len(), "histories of equal length");
    a.iter().zip(b).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max)
}

/// Asserts that all columns of two runs agree, except the excluded ones.
///
/// Differences are relative to the largest magnitude of the column, or to `floor` if that is larger.
#[track_caller]
pub(crate) fn assert_same_columns(
    what: &str,
    [a, b]: [&Run; 2],
    excluded: &[&str],
    floor: f64,
    tolerance: f64,
) {
    for (name, values) in a.columns().filter(|(name, _)| !excluded.contains(name)) {
        let size = a.largest(name).max(floor);
        let others = b.column(name);
        assert_eq!(values.len(), others.len(), "{what}, {name}: number of rows");
        for (x, y) in values.iter().zip(others) {
            assert!((x - y).abs() <= tolerance * size, "{what}, {name}: {x:e} and {y:e}, largest {size:e}");
        }
    }
}
