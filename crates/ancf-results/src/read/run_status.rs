/// Status of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RunStatus {
    /// The run is in progress.
    Running,
    /// The run has ended and written its summary.
    Ended,
    /// The run has ended without a summary, because it was killed.
    Broken,
}

/// Message about a run with [`RunStatus::Broken`].
pub const KILLED: &str = "the run was killed before it wrote its summary; `ancf resume` continues it";
