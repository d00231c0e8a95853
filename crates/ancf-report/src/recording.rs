use ancf::model::Analysis;
use ancf::record::Series;
use ancf::scales::{Dimension, Scales};
use ancf::system::State;
use ancf::{Model, Outcome, Simulation};

/// What is shown of a run: its model, states, columns, and what there is to say about it.
#[derive(Clone, Debug)]
pub struct Recording<'a> {
    /// The model, ready to run.
    pub simulation: &'a Simulation,
    /// The model in the user's units.
    pub model: &'a Model,
    /// The text of the model's file.
    pub text: &'a str,
    /// Heading of the page.
    pub title: &'a str,
    /// Instants that are drawn, in the order in which they were recorded.
    pub frames: Vec<Frame>,
    /// All columns of the run, in the user's units.
    pub series: &'a Series,
    /// Names and values of the summary.
    pub summary: Vec<(String, String)>,
    /// How the run ended.
    pub ending: Ending,
    /// Warnings and notes.
    pub messages: Vec<String>,
    /// Whether it is followed while it goes on.
    pub live: bool,
}

/// One state that is drawn.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Time or load factor in the user's units, or the number of the mode: the first number of the state's row.
    pub value: f64,
    /// The state in the solver's units. Of modes and buckling, as [`Observer::record`](ancf::Observer::record) has it:
    /// velocities are the shape.
    pub state: State,
}

/// How a run ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Ending {
    /// It goes on.
    Running,
    /// The whole analysis was carried out.
    Finished,
    /// Somebody stopped it.
    Stopped,
    /// It could not go on, for this reason.
    Failed(String),
}

impl Ending {
    /// How an analysis ended, in words.
    pub fn new(outcome: &Outcome, analysis: &Analysis) -> Self {
        match outcome {
            Outcome::Finished => Self::Finished,
            Outcome::Stopped => Self::Stopped,
            Outcome::Failed { reason, .. } => {
                Self::Failed(outcome.failure(analysis).unwrap_or_else(|| reason.clone()))
            }
        }
    }

    pub(crate) const fn kind(&self) -> &'static str {
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
    /// Units in which the states are.
    pub fn scales(&self) -> Scales {
        self.simulation.scales()
    }

    /// The name of a unit; nothing if units have no names.
    pub fn unit(&self, dimension: Dimension) -> String {
        self.model.units.as_ref().map_or_else(String::new, |units| units.of(dimension))
    }

    /// Whether states are shapes about a state: modes, or forms of buckling.
    pub const fn is_modal(&self) -> bool {
        matches!(self.model.analysis, Analysis::Modes(_) | Analysis::Buckling(_))
    }

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
