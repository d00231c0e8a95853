use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Scaled;

/// Signal of a force law: a recorded value of another part of the model, in the same state.
///
/// Formulas of the law contain its value under its name, in the units of the formulas.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct LawSignal {
    /// Name in the formulas of the law.
    #[schemars(length(min = 1))]
    pub name: String,
    /// Column of a position or velocity of a probe, of a coordinate of a joint or its rate, or of a state, such as `tip.z`.
    #[schemars(length(min = 1))]
    pub value: String,
}

impl LawSignal {
    /// Signal of a column.
    pub fn new(name: impl Into<String>, value: impl Into<String>) -> Self {
        Self { name: name.into(), value: value.into() }
    }
}
