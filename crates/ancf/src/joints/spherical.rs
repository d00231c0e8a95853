use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::joints::parts::{AngularFriction, End, JointBuilder, JointFriction, JointKind};
use crate::model::{Capability, Place};
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
    /// Dry friction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<AngularFriction>,
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
        if let Some(friction) = self.friction() {
            builder.add_ball_friction(&friction);
        }
    }

    /// Friction depends on the rotation of both ends.
    fn needs(&self) -> [Option<(Capability, &'static str)>; 2] {
        [self.friction.map(|_| (Capability::Section, "a ball joint with friction")); 2]
    }

    fn friction(&self) -> Option<JointFriction> {
        self.friction.map(AngularFriction::law)
    }

    fn bearing_keys(&self) -> &'static [&'static str] {
        &["radius"]
    }

    fn closes(&self) -> bool {
        true
    }
}
