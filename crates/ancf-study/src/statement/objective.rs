//! Objectives: the numbers that are recorded for each case.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Number recorded for each case.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Objective {
    /// Column of the results of the model, such as `tip.y`.
    pub column: String,
    /// Reduction of the column; the last value by default.
    #[serde(default)]
    pub take: Option<Take>,
    /// Index of the row, from 0, as an alternative to `take`.
    #[serde(default)]
    pub row: Option<u32>,
}

/// Reduction of a column to one number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Take {
    /// First value.
    First,
    /// Last value.
    #[default]
    Last,
    /// Mean of all rows.
    Mean,
    /// Smallest value.
    Min,
    /// Largest value.
    Max,
    /// Half the difference between the largest and the smallest value.
    Amplitude,
    /// Root mean square.
    Rms,
}

/// Objectives by name.
pub type Objectives = BTreeMap<String, Objective>;
