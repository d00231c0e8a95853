use ancf::estimate::{DiscretisationErrors, MotionErrors};
use ancf::units::Dimension;

/// End of a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The analysis is complete.
    Finished,
    /// The model was rejected, with the errors.
    Rejected(String),
    /// The computation failed, with the reason.
    Failed(String),
    /// The run was stopped, since it had too many rows or iterations.
    Stopped,
    /// The program panicked, with the message.
    Panicked(String),
}

impl Verdict {
    /// True if the analysis is complete.
    pub const fn is_finished(&self) -> bool {
        matches!(self, Self::Finished)
    }

    /// Word for tables and messages.
    pub const fn word(&self) -> &'static str {
        match self {
            Self::Finished => "finished",
            Self::Rejected(_) => "rejected",
            Self::Failed(_) => "failed",
            Self::Stopped => "stopped",
            Self::Panicked(_) => "panicked",
        }
    }

    /// Reason of an end before the analysis was complete.
    pub fn reason(&self) -> &str {
        match self {
            Self::Finished => "",
            Self::Stopped => "too many rows or iterations",
            Self::Rejected(text) | Self::Failed(text) | Self::Panicked(text) => text,
        }
    }
}

/// Column of a run with its values.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// Name of the column.
    pub name: String,
    /// Dimension of the values; `None` if they are not in the user's units.
    pub dimension: Option<Dimension>,
    /// Values of all rows.
    pub values: Vec<f64>,
}

/// Completed run.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// End of the run.
    pub verdict: Verdict,
    /// Columns of the rows.
    pub columns: Vec<Record>,
    /// Warnings of the summary.
    pub warnings: Vec<String>,
    /// Estimated errors of the mesh.
    pub errors: Option<DiscretisationErrors>,
    /// Estimated errors of a motion.
    pub motion_errors: Option<MotionErrors>,
    /// True if joint equations are redundant, so that reactions are not determined.
    pub is_redundant: bool,
    /// True if steps were divided or rejected, or increments halved.
    pub is_divided: bool,
}

impl Run {
    /// Run without rows.
    pub const fn empty(verdict: Verdict) -> Self {
        Self {
            verdict,
            columns: Vec::new(),
            warnings: Vec::new(),
            errors: None,
            motion_errors: None,
            is_redundant: false,
            is_divided: false,
        }
    }

    /// Column of a name.
    pub fn column(&self, name: &str) -> Option<&Record> {
        self.columns.iter().find(|column| column.name == name)
    }

    /// Mutable values of a column.
    pub fn values_mut(&mut self, name: &str) -> Option<&mut Vec<f64>> {
        self.columns.iter_mut().find(|column| column.name == name).map(|column| &mut column.values)
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| column.values.len())
    }

    /// Largest magnitude in a column; 0 without the column.
    pub fn largest(&self, name: &str) -> f64 {
        let values = self.column(name).map_or(&[][..], |column| &column.values);
        values.iter().fold(0.0, |largest, x| x.abs().max(largest))
    }
}
