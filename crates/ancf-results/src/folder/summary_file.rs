use ancf::Summary;
use serde::{Deserialize, Serialize};

/// Contents of `summary.json`: program, model, outcome and counts of a run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SummaryFile {
    /// Program and its version.
    pub program: String,
    /// Name of the model file.
    pub model: String,
    /// Wall-clock time in seconds. After a resumption, it is the time of the last part of the run.
    pub wall_seconds: f64,
    /// Summary of the simulation.
    #[serde(flatten)]
    pub summary: Summary,
}
