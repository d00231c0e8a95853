//! Runs of models, kept in memory.

use ancf::record::Series;
use ancf::{Model, Summary, simulate};
use nalgebra::Vector3;

/// A finished run.
pub(crate) struct Run {
    pub(crate) summary: Summary,
    series: Series,
}

impl Run {
    /// Runs a model to its end.
    pub(crate) fn of(model: &Model) -> Self {
        let mut series = Series::new();
        let summary = simulate(model, &mut series).unwrap();
        assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
        Self { summary, series }
    }

    /// A column by its name.
    pub(crate) fn column(&self, name: &str) -> &[f64] {
        self.series.column(name).unwrap_or_else(|| panic!("no column {name}"))
    }

    /// All columns by name.
    pub(crate) fn columns(&self) -> impl Iterator<Item = (&str, &[f64])> {
        self.series.columns()
    }

    /// The vectors with the components `name.x`, `name.y` and `name.z`, where `name.` may end in `v`, `a`, `f` or `m`.
    pub(crate) fn vectors(&self, name: &str) -> Vec<Vector3<f64>> {
        let [x, y, z] = ["x", "y", "z"].map(|axis| self.column(&format!("{name}{axis}")));
        x.iter().zip(y).zip(z).map(|((&x, &y), &z)| Vector3::new(x, y, z)).collect()
    }
}

/// The largest distance of two histories of vectors.
pub(crate) fn distance(a: &[Vector3<f64>], b: &[Vector3<f64>]) -> f64 {
    assert_eq!(a.len(), b.len(), "two histories of one length");
    a.iter().zip(b).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max)
}
