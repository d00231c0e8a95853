//! Problem, comparison, plot, and the solution of a model.

use ancf::record::Series;
use ancf::{Model, ModelErrors, Outcome, Summary, simulate};
use thiserror::Error;

use crate::effectivity::Effectivity;

/// Problem with a known answer.
#[derive(Clone, Copy, Debug)]
pub struct Problem {
    /// Name in lists and name of the file.
    pub name: &'static str,
    /// Title.
    pub title: &'static str,
    /// Author, year, table or equation, and computation of the reference.
    pub source: &'static str,
    /// Text drawing.
    pub sketch: &'static str,
    /// Purpose and tolerance.
    pub goal: &'static str,
    /// Solves the problem.
    pub run: fn() -> Result<Findings, VerificationError>,
}

/// Failure of a problem.
#[derive(Debug, Error)]
pub enum VerificationError {
    /// The model is invalid: an error in the problem.
    #[error(transparent)]
    Model(#[from] ModelErrors),
    /// The model could not be run or recorded.
    #[error(transparent)]
    Run(#[from] ancf::Error),
    /// The analysis failed.
    #[error("{reason} (at {at})")]
    Failed {
        /// Reason.
        reason: String,
        /// Location.
        at: String,
    },
    /// A required column or row is missing.
    #[error("the results have no {0}")]
    Missing(String),
}

/// Comparisons and plots of a problem.
#[derive(Clone, Debug, Default)]
pub struct Findings {
    /// Comparisons with references.
    pub comparisons: Vec<Comparison>,
    /// Estimated errors of the mesh, compared with those against references.
    pub effectivities: Vec<Effectivity>,
    /// Plots, at least one.
    pub plots: Vec<Plot>,
}

impl Findings {
    /// Adds a comparison. The largest permitted error is `tolerance` times `scale`.
    ///
    /// The scale is the size of the reference, or of the structure if the reference is small or zero.
    pub fn compare(
        &mut self,
        what: impl Into<String>,
        ours: f64,
        reference: f64,
        scale: f64,
        tolerance: f64,
    ) {
        let what = what.into();
        self.comparisons.push(Comparison { what, ours, reference, scale: scale.abs(), tolerance });
    }

    /// Adds a plot.
    pub fn plot(&mut self, plot: Plot) {
        self.plots.push(plot);
    }

    /// Returns the first comparison that does not hold.
    pub fn broken(&self) -> Option<&Comparison> {
        self.comparisons.iter().find(|comparison| !comparison.holds())
    }
}

/// Computed number and its reference.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Name with the unit.
    pub what: String,
    /// Computed number.
    pub ours: f64,
    /// Reference.
    pub reference: f64,
    /// Scale of the error.
    pub scale: f64,
    /// Largest permitted error, relative to the scale.
    pub tolerance: f64,
}

impl Comparison {
    /// Returns |computed − reference| / scale.
    pub fn error(&self) -> f64 {
        (self.ours - self.reference).abs() / self.scale
    }

    /// True if the error is within the tolerance. NaN is not.
    pub fn holds(&self) -> bool {
        self.error() <= self.tolerance
    }
}

/// Plot of curves.
#[derive(Clone, Debug, Default)]
pub struct Plot {
    /// Caption.
    pub title: String,
    /// Labels of the axes, with units.
    pub axes: [String; 2],
    /// True for equal scales of both axes.
    pub equal: bool,
    /// True for each logarithmic axis.
    pub logarithmic: [bool; 2],
    /// Curves.
    pub curves: Vec<PlotCurve>,
}

impl Plot {
    /// Creates a plot with linear axes.
    pub fn new(title: impl Into<String>, axes: [&str; 2], curves: Vec<PlotCurve>) -> Self {
        Self { title: title.into(), axes: axes.map(str::to_owned), curves, ..Self::default() }
    }

    /// Sets equal scales of both axes.
    #[must_use]
    pub fn with_equal_scales(self) -> Self {
        Self { equal: true, ..self }
    }

    /// Sets the logarithmic axes.
    #[must_use]
    pub fn with_logarithmic_axes(self, logarithmic: [bool; 2]) -> Self {
        Self { logarithmic, ..self }
    }
}

/// Curve of a plot.
#[derive(Clone, Debug)]
pub struct PlotCurve {
    /// Name in the legend.
    pub name: String,
    /// Line or markers.
    pub mark: Mark,
    /// Points.
    pub points: Vec<[f64; 2]>,
}

impl PlotCurve {
    /// Creates a line: a computed curve.
    pub fn line(name: impl Into<String>, points: Vec<[f64; 2]>) -> Self {
        Self { name: name.into(), mark: Mark::Line, points }
    }

    /// Creates markers: a reference.
    pub fn points(name: impl Into<String>, points: Vec<[f64; 2]>) -> Self {
        Self { name: name.into(), mark: Mark::Points, points }
    }
}

/// Representation of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Line: a computed curve.
    Line,
    /// Markers: a reference.
    Points,
}

/// Results of a model.
#[derive(Debug)]
pub struct SolvedModel {
    /// Summary of the run.
    pub summary: Summary,
    /// Rows.
    pub series: Series,
}

impl SolvedModel {
    /// Returns a column.
    ///
    /// # Errors
    /// If there is no column of this name.
    pub fn column(&self, name: &str) -> Result<&[f64], VerificationError> {
        self.series.column(name).ok_or_else(|| VerificationError::Missing(format!("column {name}")))
    }

    /// Returns the last value of a column.
    ///
    /// # Errors
    /// If there is no column of this name, or if it is empty.
    pub fn last(&self, name: &str) -> Result<f64, VerificationError> {
        self.column(name)?.last().copied().ok_or_else(|| VerificationError::Missing(format!("row in {name}")))
    }

    /// Returns the value of a column at an instant of a row.
    ///
    /// # Errors
    /// If there is no column of this name, or no row at this instant.
    pub(crate) fn at(&self, name: &str, time: f64) -> Result<f64, VerificationError> {
        let row = self.column("t")?.iter().position(|t| (t - time).abs() < 1e-6);
        let row = row.ok_or_else(|| VerificationError::Missing(format!("row at t = {time}")))?;
        Ok(self.column(name)?[row])
    }

    /// Returns two columns as points.
    ///
    /// # Errors
    /// If there is no column of one of the names.
    pub fn points(&self, x: &str, y: &str) -> Result<Vec<[f64; 2]>, VerificationError> {
        Ok(self.column(x)?.iter().zip(self.column(y)?).map(|(&x, &y)| [x, y]).collect())
    }
}

/// Runs a model, given as the text of a model file.
///
/// # Errors
/// If the model is invalid or the run does not finish.
pub fn solve(model: &str) -> Result<SolvedModel, VerificationError> {
    let model = Model::parse(model)?;
    let mut series = Series::new();
    let summary = simulate(&model, &mut series)?;
    match &summary.outcome {
        Outcome::Failed { reason, at, .. } => {
            Err(VerificationError::Failed { reason: reason.clone(), at: at.clone() })
        }
        Outcome::Finished | Outcome::Stopped => Ok(SolvedModel { summary, series }),
    }
}
