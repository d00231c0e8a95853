use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Place;

/// A point whose position, velocity and acceleration are recorded.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Name in the outputs: the columns are `name.x`, `name.vx`, `name.ax` and so on.
    #[schemars(length(min = 1))]
    pub name: String,
    /// The point.
    pub on: Place,
}

/// What is written, and how often.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Output {
    /// Time between recorded instants, on each of which a step ends; every step is recorded if left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub interval: Option<f64>,
    /// Record every so many of these; the first and the last instant always are.
    #[schemars(range(min = 1))]
    pub every: u32,
    /// Write `probes.csv`.
    pub csv: bool,
    /// Write `probes.npz`, one binary array a column, readable by NumPy.
    pub npz: bool,
}

impl Default for Output {
    fn default() -> Self {
        Self { interval: None, every: 1, csv: true, npz: true }
    }
}
