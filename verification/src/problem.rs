use ancf::record::Series;
use ancf::{Model, ModelErrors, Outcome, Summary, simulate};
use thiserror::Error;

/// A problem with a known answer.
#[derive(Clone, Copy, Debug)]
pub struct Problem {
    /// Its name in lists, as that of its file.
    pub name: &'static str,
    /// What it is, in a line.
    pub title: &'static str,
    /// Author, year, table or equation, and how the reference was computed.
    pub source: &'static str,
    /// A drawing in characters.
    pub sketch: &'static str,
    /// What is shown by it, and within which tolerance.
    pub goal: &'static str,
    /// Solves it.
    pub run: fn() -> Result<Findings, Error>,
}

/// Why a problem could not be solved.
#[derive(Debug, Error)]
pub enum Error {
    /// The model is not valid: a mistake in the problem.
    #[error(transparent)]
    Model(#[from] ModelErrors),
    /// It could not be run or recorded.
    #[error(transparent)]
    Run(#[from] ancf::Error),
    /// The numerics gave up.
    #[error("{reason} (at {at})")]
    Failed {
        /// Why.
        reason: String,
        /// Where.
        at: String,
    },
    /// A column or a row that should be there is not.
    #[error("the results have no {0}")]
    Missing(String),
}

/// What came out.
#[derive(Clone, Debug, Default)]
pub struct Findings {
    /// Our numbers beside the references.
    pub comparisons: Vec<Comparison>,
    /// Plots, at least one.
    pub plots: Vec<Plot>,
}

impl Findings {
    /// Adds a comparison whose error may be at most `tolerance` times `scale`.
    ///
    /// The scale is the size against which an error counts: that of the reference, or of the structure where the reference is
    /// small or zero.
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

    /// The first comparison that does not hold.
    pub fn broken(&self) -> Option<&Comparison> {
        self.comparisons.iter().find(|comparison| !comparison.holds())
    }
}

/// One number of ours beside its reference.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// What it is, with its unit if it has one.
    pub what: String,
    /// Ours.
    pub ours: f64,
    /// The reference.
    pub reference: f64,
    /// The size against which the error counts.
    pub scale: f64,
    /// The largest error permitted, relative to the scale.
    pub tolerance: f64,
}

impl Comparison {
    /// |ours − reference| / scale.
    pub fn error(&self) -> f64 {
        (self.ours - self.reference).abs() / self.scale
    }

    /// Whether the error is within the tolerance; not a number is not.
    pub fn holds(&self) -> bool {
        self.error() <= self.tolerance
    }
}

/// A plot.
#[derive(Clone, Debug, Default)]
pub struct Plot {
    /// What it shows, for the caption.
    pub title: String,
    /// Names of the axes, with units.
    pub axes: [String; 2],
    /// Whether a length is the same on both axes.
    pub equal: bool,
    /// Whether each axis is logarithmic.
    pub logarithmic: [bool; 2],
    /// What is drawn.
    pub curves: Vec<Curve>,
}

/// A curve of a plot.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Its name in the legend.
    pub name: String,
    /// How it is drawn.
    pub mark: Mark,
    /// Its points.
    pub points: Vec<[f64; 2]>,
}

impl Curve {
    /// A line: ours.
    pub fn line(name: impl Into<String>, points: Vec<[f64; 2]>) -> Self {
        Self { name: name.into(), mark: Mark::Line, points }
    }

    /// Points: a reference.
    pub fn points(name: impl Into<String>, points: Vec<[f64; 2]>) -> Self {
        Self { name: name.into(), mark: Mark::Points, points }
    }
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A line: ours.
    Line,
    /// Points: a reference.
    Points,
}

/// The results of a model.
#[derive(Debug)]
pub struct Solved {
    /// The run in a few numbers.
    pub summary: Summary,
    /// Its rows.
    pub series: Series,
}

impl Solved {
    /// A column.
    ///
    /// # Errors
    /// If there is none of this name.
    pub fn column(&self, name: &str) -> Result<&[f64], Error> {
        self.series.column(name).ok_or_else(|| Error::Missing(format!("column {name}")))
    }

    /// The last value of a column.
    ///
    /// # Errors
    /// If there is none of this name or it is empty.
    pub fn last(&self, name: &str) -> Result<f64, Error> {
        self.column(name)?.last().copied().ok_or_else(|| Error::Missing(format!("row in {name}")))
    }

    /// Two columns as points.
    ///
    /// # Errors
    /// If one of them is not there.
    pub fn points(&self, x: &str, y: &str) -> Result<Vec<[f64; 2]>, Error> {
        Ok(self.column(x)?.iter().zip(self.column(y)?).map(|(&x, &y)| [x, y]).collect())
    }
}

/// Runs a model stated as in a model file to its end.
///
/// # Errors
/// If the model is not valid or the run ends early.
pub fn solve(model: &str) -> Result<Solved, Error> {
    let model = Model::parse(model)?;
    let mut series = Series::new();
    let summary = simulate(&model, &mut series)?;
    match &summary.outcome {
        Outcome::Failed { reason, at, .. } => Err(Error::Failed { reason: reason.clone(), at: at.clone() }),
        Outcome::Finished | Outcome::Stopped => Ok(Solved { summary, series }),
    }
}
