//! Parameters of a study.

use ancf::schema::join;
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value as Json;
use toml::Value;

use super::distribution::ValueRule;

/// Values of a parameter.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Parameter {
    /// Listed values.
    List(#[schemars(with = "Vec<Json>", length(min = 1))] Vec<Value>),
    /// Rule.
    Rule(ValueRule),
}

impl Parameter {
    /// Returns the values of a list or range, `None` for a distribution.
    pub fn values(&self) -> Option<Vec<Value>> {
        match self {
            Self::List(values) => Some(values.clone()),
            Self::Rule(rule) => rule.values(),
        }
    }

    /// Returns the number of values of a list or range, `None` for a distribution.
    pub const fn count(&self) -> Option<usize> {
        match self {
            Self::List(values) => Some(values.len()),
            Self::Rule(rule) => rule.count(),
        }
    }

    /// Returns the first value of a list or range or the median of a distribution. `None` for an empty list.
    pub fn first(&self) -> Option<Value> {
        match self {
            Self::List(values) => values.first().cloned(),
            Self::Rule(rule) => Some(rule.first()),
        }
    }
}

/// Returns the path of a parameter in the study file.
pub(crate) fn parameter_path(path: &str) -> String {
    join("parameters", path)
}
