use ancf::estimate::BodyError;
use ancf::model::{Analysis, Modes};
use ancf::record::Series;
use ancf::solver::equations::State;
use ancf::units::{Dimension, Scales};
use ancf::{Model, Outcome, Simulation};
use ancf_surface::BodySurfaces;

/// Run with its model, states, columns and messages.
#[derive(Clone, Debug)]
pub struct Recording<'a> {
    /// Simulation of the model.
    pub simulation: &'a Simulation,
    /// Model in the user's units.
    pub model: &'a Model,
    /// Text of the model file.
    pub text: &'a str,
    /// Heading of the page.
    pub title: &'a str,
    /// States to be drawn, in the order in which they were recorded.
    pub frames: Vec<Snapshot>,
    /// All columns of the run, in the user's units.
    pub series: &'a Series,
    /// Names and values of the summary.
    pub summary: Vec<(String, String)>,
    /// Surfaces of the rigid bodies.
    pub surfaces: &'a BodySurfaces,
    /// Contributions of the bodies to the estimated error of the mesh.
    pub body_errors: Vec<BodyError>,
    /// Outcome of the run.
    pub ending: Ending,
    /// Warnings and notes.
    pub messages: Vec<String>,
    /// True if the page follows a run in progress.
    pub live: bool,
}

/// State to be drawn.
#[derive(Clone, Debug)]
pub struct Snapshot {
    /// First number of the row of the state: time or load factor in the user's units, or the number of the mode.
    pub value: f64,
    /// State in the units of the solver. Velocities of modes and buckling shapes are the shape, accelerations the imaginary part of
    /// the shape of a damped mode, as in [`Observer::record`](ancf::Observer::record).
    pub state: State,
}

/// Outcome of a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Ending {
    /// The run is in progress.
    Running,
    /// The analysis is complete.
    Finished,
    /// The user stopped the run.
    Stopped,
    /// The run failed for this reason.
    Failed(String),
}

impl Ending {
    /// Converts the outcome of an analysis.
    pub fn new(outcome: &Outcome, analysis: &Analysis) -> Self {
        match outcome {
            Outcome::Finished => Self::Finished,
            Outcome::Stopped => Self::Stopped,
            Outcome::Failed { reason, .. } => {
                Self::Failed(outcome.failure(analysis).unwrap_or_else(|| reason.clone()))
            }
        }
    }

    /// Word in the scene.
    pub(crate) const fn word(&self) -> &'static str {
        match self {
            Self::Running => "running",
            Self::Finished => "finished",
            Self::Stopped => "stopped",
            Self::Failed(_) => "failed",
        }
    }

    pub(crate) fn message(&self) -> &str {
        if let Self::Failed(reason) = self { reason } else { "" }
    }
}

impl Recording<'_> {
    /// Units of the states.
    pub fn scales(&self) -> Scales {
        self.simulation.scales()
    }

    /// Name of the unit of a dimension; empty if the model does not name its units.
    pub fn unit(&self, dimension: Dimension) -> String {
        self.model.units.as_ref().map_or_else(String::new, |units| units.of(dimension))
    }

    /// True if the states are mode shapes or buckling shapes.
    pub const fn is_modal(&self) -> bool {
        self.model.analysis.has_shapes()
    }

    /// True if the states are mode shapes with an imaginary part.
    pub const fn is_complex(&self) -> bool {
        matches!(self.model.analysis, Analysis::Modes(Modes { damped: true, .. }))
    }

    /// Word for the analysis in the scene.
    pub(crate) const fn analysis(&self) -> &'static str {
        match self.model.analysis {
            Analysis::Dynamics(_) => "dynamics",
            Analysis::Statics(_) => "statics",
            Analysis::Path(_) => "path",
            Analysis::Modes(_) => "modes",
            Analysis::Buckling(_) => "buckling",
        }
    }
}
