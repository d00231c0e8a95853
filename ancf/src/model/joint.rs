use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Place, TimeFunction};

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
    /// A clamp to a frame that turns about the place as it is told.
    Drive {
        /// Name in outputs and messages.
        #[schemars(length(min = 1))]
        name: String,
        /// The end that is turned, and receives the reaction.
        a: Place,
        /// Direction of the axis in the global frame; its length does not matter.
        axis: [f64; 3],
        /// Angle by which the function of time is multiplied, in radians; 1 by default.
        #[serde(default = "one")]
        angle: f64,
        /// Function of time; statics ignores it and turns with the load.
        time: TimeFunction,
        /// Which gradients are tied besides the position, by default as those of a clamp.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        fix: Option<Clamped>,
    },
}

/// What a drive is tied to.
static GROUND: End = End::Ground;

fn one() -> f64 {
    1.0
}

impl Joint {
    /// Name in outputs and messages.
    pub fn name(&self) -> &str {
        match self {
            Self::Clamp { name, .. }
            | Self::Revolute { name, .. }
            | Self::Spherical { name, .. }
            | Self::Drive { name, .. } => name,
        }
    }

    /// The two ends.
    pub fn ends(&self) -> (&Place, &End) {
        match self {
            Self::Clamp { a, b, .. } | Self::Revolute { a, b, .. } | Self::Spherical { a, b, .. } => (a, b),
            Self::Drive { a, .. } => (a, &GROUND),
        }
    }

    /// Its function of time, if it has one.
    pub const fn time(&self) -> Option<&TimeFunction> {
        match self {
            Self::Clamp { .. } | Self::Revolute { .. } | Self::Spherical { .. } => None,
            Self::Drive { time, .. } => Some(time),
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
    /// A point of the fixed frame, to which statics draws the first end by the load.
    #[serde(untagged)]
    Point(Ground),
}

/// A point of the fixed frame.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ground {
    /// The point, length.
    pub point: [f64; 3],
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
