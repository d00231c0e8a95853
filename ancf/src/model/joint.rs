use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Place;

/// A joint between a body and the ground or another body.
///
/// Reactions are reported as the force and the moment that the joint exerts on its end `a`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Joint {
    /// Ties position and orientation.
    Clamp {
        /// Name in outputs and messages.
        #[schemars(length(min = 1))]
        name: String,
        /// The end that receives the reaction.
        a: Place,
        /// The other end; the ground by default.
        #[serde(default)]
        b: End,
        /// Which gradients are tied besides the position: `"all"` for beams of the continuum formulation, `"section"`
        /// for all else, by default.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        fix: Option<Clamped>,
    },
    /// A hinge: ties the position and leaves rotation about one axis.
    Revolute {
        /// Name in outputs and messages.
        #[schemars(length(min = 1))]
        name: String,
        /// The end that receives the reaction.
        a: Place,
        /// The other end; the ground by default.
        #[serde(default)]
        b: End,
        /// Direction of the axis in the undeformed state, in the global frame; its length does not matter.
        axis: [f64; 3],
    },
    /// A ball joint: ties the position.
    Spherical {
        /// Name in outputs and messages.
        #[schemars(length(min = 1))]
        name: String,
        /// The end that receives the reaction.
        a: Place,
        /// The other end; the ground by default.
        #[serde(default)]
        b: End,
    },
}

impl Joint {
    /// Name in outputs and messages.
    pub fn name(&self) -> &str {
        match self {
            Self::Clamp { name, .. } | Self::Revolute { name, .. } | Self::Spherical { name, .. } => name,
        }
    }

    /// The two ends.
    pub fn ends(&self) -> (&Place, &End) {
        match self {
            Self::Clamp { a, b, .. } | Self::Revolute { a, b, .. } | Self::Spherical { a, b, .. } => (a, b),
        }
    }
}

/// What a joint ties its first end to.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum End {
    /// The fixed frame: `"ground"`.
    #[default]
    Ground,
    /// A place on another body.
    #[serde(untagged)]
    Place(Place),
}

/// Which gradients a clamp ties besides the position.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Clamped {
    /// r_x, r_y and r_z: all twelve coordinates of the node, as Kim et al. (2017) do. Stretch and shear of the axis
    /// are then zero at the clamp, which stiffens coarse meshes: 8/9 of the exact elongation for one element.
    All,
    /// r_y and r_z only: the section is fixed and the axis is free to stretch, exact in tension. Of a cable, the direction
    /// of the tangent.
    Section,
}
