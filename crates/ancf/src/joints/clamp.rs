use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::joints::parts::{ClampedGradients, End, JointBuilder, JointKind};
use crate::model::{Capability, Place};
use crate::units::Scaled;

/// Clamp: constrains position and orientation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Clamp {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// First end, on which the reaction acts.
    pub a: Place,
    /// Second end; the ground by default.
    #[serde(default)]
    pub b: End,
    /// Gradients that are constrained in addition to the position. By default `"all"` for a beam of the continuum formulation on the
    /// ground, on a rigid body, or on such a beam with parallel sections; otherwise `"section"`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fix: Option<ClampedGradients>,
}

impl JointKind for Clamp {
    fn word(&self) -> &'static str {
        "clamp"
    }

    fn name(&self) -> &str {
        &self.name
    }

    fn ends(&self) -> (&Place, &End) {
        (&self.a, &self.b)
    }

    fn removes(&self) -> usize {
        6
    }

    fn build(&self, builder: &mut JointBuilder<'_>) {
        builder.coincide();
        builder.clamp(self.fix);
    }

    fn needs(&self) -> [Option<(Capability, &'static str)>; 2] {
        [Some((Capability::Direction, "a clamp")); 2]
    }

    fn closes(&self) -> bool {
        true
    }
}
