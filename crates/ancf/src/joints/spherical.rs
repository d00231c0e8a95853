use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::joints::parts::{End, JointBuilder, JointKind};
use crate::model::Place;
use crate::units::Scaled;

/// Ball joint: constrains the position.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Spherical {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// First end, on which the reaction acts.
    pub a: Place,
    /// Second end; the ground by default.
    #[serde(default)]
    pub b: End,
}

impl JointKind for Spherical {
    fn word(&self) -> &'static str {
        "spherical"
    }

    fn name(&self) -> &str {
        &self.name
    }

    fn ends(&self) -> (&Place, &End) {
        (&self.a, &self.b)
    }

    fn removes(&self) -> usize {
        3
    }

    fn build(&self, builder: &mut JointBuilder<'_>) {
        builder.coincide();
    }

    fn closes(&self) -> bool {
        true
    }
}
