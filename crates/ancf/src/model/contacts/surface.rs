use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::model::bodies::Place;

/// What bodies may touch, and how hard and rough they are there. Bodies are round tubes about their axes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Contact {
    /// What the bodies may touch.
    pub with: Against,
    /// Names of the beams and cables; all but the one that carries an obstacle, by default.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub bodies: Vec<String>,
    /// Radius of the bodies, length; that of circles and tubes by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: Option<f64>,
    /// Contact points of each element; by default so many that their distance suits the obstacle and the radius.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 1, max = 10000))]
    pub points: Option<u32>,
    /// Force per length of a body and per depth, force/length².
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub stiffness: f64,
    /// Depth over which the stiffness grows from zero, length; a fiftieth of the smallest radius by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub transition: Option<f64>,
    /// Part by which the force is less at each speed of parting, and more when meeting, time/length.
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub damping: f64,
    /// Coefficient of friction; none in statics.
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub friction: f64,
    /// Sliding speed below which friction is viscous, length/time; by default a thousandth of the length of the longest body
    /// over the duration.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub slip_speed: Option<f64>,
}

/// What bodies may touch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Against {
    /// The half space behind a plane.
    Plane {
        /// A point of it in the undeformed state, length.
        point: [f64; 3],
        /// Its normal in the undeformed state, towards the bodies; its length does not matter.
        normal: [f64; 3],
        /// What carries it; the ground by default.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        on: Option<Place>,
    },
    /// A ball, or a round hollow.
    Sphere {
        /// Its centre in the undeformed state, length.
        center: [f64; 3],
        /// Its radius, length.
        #[schemars(extend("exclusiveMinimum" = 0))]
        radius: f64,
        /// Whether the bodies are inside.
        #[serde(default)]
        inside: bool,
        /// What carries it; the ground by default.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        on: Option<Place>,
    },
    /// An endless cylinder, or a bore.
    Cylinder {
        /// A point of its axis in the undeformed state, length.
        point: [f64; 3],
        /// Direction of its axis in the undeformed state; its length does not matter.
        axis: [f64; 3],
        /// Its radius, length.
        #[schemars(extend("exclusiveMinimum" = 0))]
        radius: f64,
        /// Whether the bodies are inside.
        #[serde(default)]
        inside: bool,
        /// What carries it; the ground by default.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        on: Option<Place>,
    },
    /// The bodies each other, and each itself.
    Bodies,
}

impl Against {
    /// What carries an obstacle, if not the ground.
    pub const fn on(&self) -> Option<&Place> {
        match self {
            Self::Plane { on, .. } | Self::Sphere { on, .. } | Self::Cylinder { on, .. } => on.as_ref(),
            Self::Bodies => None,
        }
    }
}
