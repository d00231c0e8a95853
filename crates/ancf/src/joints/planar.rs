use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::parts::measures;
use crate::joints::parts::{End, JointBuilder, JointFriction, JointKind, LinearFriction};
use crate::model::{Capability, Place};
use crate::units::Scaled;

/// Planar joint: allows displacements in a plane and rotation about its normal.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Planar {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// First end, on which the reaction acts.
    pub a: Place,
    /// Second end, to which the plane is fixed; the ground by default.
    #[serde(default)]
    pub b: End,
    /// Normal of the plane in the undeformed state, in the global frame. Its magnitude has no effect.
    #[unit(none)]
    pub normal: [f64; 3],
    /// Dry friction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<LinearFriction>,
}

impl JointKind for Planar {
    fn word(&self) -> &'static str {
        "planar"
    }

    fn noun(&self) -> &'static str {
        "planar joint"
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
        let normal = Vector3::from(self.normal).normalize();
        let measures = measures::planar(builder.a(), builder.b(), normal);
        builder.keep(&[("plane", 1), ("normal", 2)], measures);
        builder.expect_aligned(&[normal]);
        if let Some(friction) = self.friction() {
            builder.add_plane_friction(normal, &friction);
        }
    }

    fn friction(&self) -> Option<JointFriction> {
        self.friction.map(LinearFriction::law)
    }

    fn needs(&self) -> [Option<(Capability, &'static str)>; 2] {
        [Some((Capability::Section, "a planar joint")); 2]
    }

    fn axes(&self) -> Vec<(&'static str, [f64; 3])> {
        vec![("normal", self.normal)]
    }
}
