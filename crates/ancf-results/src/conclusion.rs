use ancf::Summary;
use serde::{Deserialize, Serialize};

/// The contents of `summary.json`: how a run ended and what it did.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Conclusion {
    /// The program and its version.
    pub program: String,
    /// What the model's file was called.
    pub model: String,
    /// Time of the clock; of a run that was continued, of its last piece.
    pub wall_seconds: f64,
    /// What the run did.
    #[serde(flatten)]
    pub summary: Summary,
}
