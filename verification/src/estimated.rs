//! Estimated errors of the mesh, compared with the errors against references.

use ancf::estimate::{DiscretisationErrors, Resolution};
use ancf::record::{Series, Sink};

use crate::{Effectivity, Findings, Plot, PlotCurve, SolvedModel, VerificationError, solve};

/// Permitted ratios of the estimated and the true error in statics and above an error of 10 %, and of frequencies and critical load
/// factors below it.
const STATICS: [f64; 2] = [0.5, 2.0];
const EIGENVALUES: [f64; 2] = [0.8, 1.25];
const LARGE: f64 = 0.1;

/// Smallest error of a plot with logarithmic axes.
const SMALLEST: f64 = 1e-16;

impl SolvedModel {
    /// Returns the results with value + error in place of the values; `None` without a good estimate.
    pub(crate) fn corrected(&self) -> Option<Self> {
        let is_good = |errors: &&DiscretisationErrors| errors.resolution == Resolution::Good;
        let errors = self.summary.errors.as_ref().filter(is_good)?;
        let eigenvalues = ["frequency", "factor"].into_iter().find(|name| self.series.column(name).is_some());
        let names: Vec<String> = self.series.names().map(str::to_owned).collect();
        let count = self.series.columns().next()?.1.len();
        let value = |name: &str, row: usize| {
            let value = self.series.column(name).map_or(f64::NAN, |values| values[row]);
            let found = errors.values.iter().find(|error| error.column == name).filter(|_| row + 1 == count);
            let error = match (eigenvalues, found) {
                (Some(column), _) if column == name => {
                    self.series.column(&format!("{column}_error")).map_or(f64::NAN, |values| values[row])
                }
                (_, Some(found)) => found.error,
                _ => 0.0,
            };
            // Rigid modes remain rigid.
            if value == 0.0 && error.is_nan() { 0.0 } else { value + error }
        };
        let mut series = Series::new();
        series.begin(&names).ok()?;
        for row in 0..count {
            let row: Vec<f64> = names.iter().map(|name| value(name, row)).collect();
            let _ = series.record(&row).ok()?;
        }
        Some(Self { summary: self.summary.clone(), series })
    }
}

impl Effectivity {
    /// Creates the effectivity of a value with its correction and its reference.
    pub(crate) fn new(
        what: &str,
        level: u32,
        solved: &SolvedModel,
        [ours, better, reference]: [f64; 3],
    ) -> Self {
        let (estimate, error) = (better - ours, reference - ours);
        let is_eigenvalue = solved.summary.errors.as_ref().is_some_and(|errors| errors.eigenvalue.is_some());
        let is_small = estimate.abs() <= LARGE * ours.abs();
        let range = if is_eigenvalue && is_small { EIGENVALUES } else { STATICS };
        Self { what: what.to_owned(), level, estimate, error, range }
    }
}

/// Solves a model on several meshes. Compares value + error on the finest mesh with the reference, and all estimates with the errors.
///
/// # Errors
/// If a model fails, lacks a value or has no estimate.
pub(crate) fn estimated(
    what: &str,
    levels: &[u32],
    model: impl Fn(u32) -> String,
    reading: impl Fn(&SolvedModel) -> Result<f64, VerificationError>,
    reference: f64,
    tolerance: f64,
) -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    let [mut before, mut after] = [Vec::new(), Vec::new()];
    let scale = reference.abs();
    for &level in levels {
        let solved = solve(&model(level))?;
        let missing = || VerificationError::Missing(format!("estimate with {level} elements"));
        let corrected = solved.corrected().ok_or_else(missing)?;
        let (ours, better) = (reading(&solved)?, reading(&corrected)?);
        let relative = |value: f64| [f64::from(level), ((value - reference).abs() / scale).max(SMALLEST)];
        before.push(relative(ours));
        after.push(relative(better));
        findings.effectivities.push(Effectivity::new(what, level, &solved, [ours, better, reference]));
        if Some(&level) == levels.last() {
            findings.compare(format!("{what}: value + estimated error"), better, reference, scale, tolerance);
        }
    }
    let curves = vec![PlotCurve::line("value", before), PlotCurve::line("value + estimated error", after)];
    let plot = Plot::new("Errors against the number of elements", ["elements", "relative error"], curves);
    findings.plot(plot.with_logarithmic_axes([true, true]));
    Ok(findings)
}
