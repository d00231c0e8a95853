//! Content of a study file.

use std::collections::BTreeMap;
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Deserialize;

use super::distribution::ValueRule;
use super::layout::{CaseLayout, Combine};
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

impl Study {
    /// Returns the distributions by the paths of their parameters.
    pub fn distributions(&self) -> impl Iterator<Item = (&str, &ValueRule)> {
        self.parameters.iter().filter_map(|(path, parameter)| match parameter {
            Parameter::Rule(rule) if rule.count().is_none() => Some((path.as_str(), rule)),
            _ => None,
        })
    }

    /// Returns the number of samples per combination of lists and ranges.
    pub fn samples(&self) -> u32 {
        if self.distributions().next().is_some() { self.samples.unwrap_or(1) } else { 1 }
    }

    /// Returns the numbering of the cases, `None` if their number cannot be represented.
    pub fn layout(&self) -> Option<CaseLayout> {
        let lengths: Vec<Option<usize>> = self.parameters.values().map(Parameter::count).collect();
        CaseLayout::new(&lengths, self.samples() as usize, self.combine)
    }
}
