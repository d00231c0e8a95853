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
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Output {
    /// Record every so many steps; the first and the last instant always are.
    #[schemars(range(min = 1))]
    pub every: u32,
    /// Write `probes.csv`.
    pub csv: bool,
    /// Write `probes.npz`, one binary array a column, readable by NumPy.
    pub npz: bool,
}

impl Default for Output {
    fn default() -> Self {
        Self { every: 1, csv: true, npz: true }
    }
}
