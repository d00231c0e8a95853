//! Content of a study file.

use std::collections::BTreeMap;
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Deserialize;

use super::objective::Objectives;
use super::parameter::Parameter;
use super::sampling::Sampling;

/// Study as stated in its file.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Study {
    /// Model file, relative to the study file.
    #[schemars(length(min = 1))]
    pub model: PathBuf,
    /// Number of samples drawn from all distributions together.
    #[serde(default)]
    #[schemars(range(min = 1, max = 10_000_000))]
    pub samples: Option<u32>,
    /// Seed of the samples.
    #[serde(default)]
    pub seed: u32,
    /// Sampling method.
    #[serde(default)]
    pub sampling: Sampling,
    /// Combination of lists and ranges.
    #[serde(default)]
    pub combine: Combine,
    /// Parameters by the path of the key in the model.
    pub parameters: BTreeMap<String, Parameter>,
    /// Numbers recorded for each case.
    #[serde(default)]
    pub objectives: Objectives,
}

/// Combination of the values of lists and ranges.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Combine {
    /// Every value with every value of the others.
    #[default]
    Grid,
    /// The first value with the first of the others, the second with the second.
    Zip,
}

impl Study {
    /// Returns the number of samples per combination of lists and ranges.
    pub fn samples(&self) -> u32 {
        let is_drawn = self.parameters.values().any(|parameter| parameter.count().is_none());
        if is_drawn { self.samples.unwrap_or(1) } else { 1 }
    }

    /// Returns the number of cases, `None` if it cannot be represented.
    pub(crate) fn case_count(&self) -> Option<usize> {
        let mut counts = self.parameters.values().filter_map(Parameter::count);
        let combinations = match self.combine {
            Combine::Grid => counts.try_fold(1, usize::checked_mul)?,
            Combine::Zip => counts.max().unwrap_or(1),
        };
        combinations.checked_mul(self.samples() as usize)
    }
}
