use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::model::bodies::Place;
use crate::units::Scaled;

/// Contact of bodies with an obstacle or with each other. Bodies are round tubes about their axes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Contact {
    /// Contact partner of the bodies.
    pub with: Against,
    /// Names of the beams and cables; all except the body that carries the obstacle by default.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub bodies: Vec<String>,
    /// Radius of the bodies, length; that of circles and tubes by default.
    #[unit(length)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: Option<f64>,
    /// Contact points of each element; by default a number that resolves the obstacle and the radius.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 1, max = 10000))]
    pub points: Option<u32>,
    /// Force per length of a body and per depth, force/length².
    #[unit(force / length^2)]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub stiffness: f64,
    /// Depth over which the stiffness grows from zero, length; 1/50 of the smallest radius by default.
    #[unit(length)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub transition: Option<f64>,
    /// Damping coefficient c, time/length. The factor of the force is 1 − c v for small velocities v of separation.
    #[unit(time / length)]
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub damping: f64,
    /// Coefficient of friction; 0 by default. Statics ignores friction.
    #[serde(default)]
    #[unit(number)]
    #[schemars(extend("minimum" = 0))]
    pub friction: f64,
    /// Sliding speed below which friction is viscous, length/time; by default 1/1000 of the length of the longest body
    /// divided by the duration.
    #[unit(length / time)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub slip_speed: Option<f64>,
}

/// Contact partner: an obstacle, or the bodies themselves.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Against {
    /// Half space behind a plane.
    Plane {
        /// Point of the plane in the undeformed state, length.
        #[unit(length)]
        point: [f64; 3],
        /// Normal in the undeformed state, towards the bodies, of any length.
        #[unit(none)]
        normal: [f64; 3],
        /// Place that carries the obstacle; the ground by default.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        on: Option<Place>,
    },
    /// Sphere, solid or hollow.
    Sphere {
        /// Centre in the undeformed state, length.
        #[unit(length)]
        center: [f64; 3],
        /// Radius, length.
        #[unit(length)]
        #[schemars(extend("exclusiveMinimum" = 0))]
        radius: f64,
        /// True if the bodies are inside.
        #[serde(default)]
        inside: bool,
        /// Place that carries the obstacle; the ground by default.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        on: Option<Place>,
    },
    /// Infinite cylinder, solid or hollow.
    Cylinder {
        /// Point of the axis in the undeformed state, length.
        #[unit(length)]
        point: [f64; 3],
        /// Direction of the axis in the undeformed state, of any length.
        #[unit(none)]
        axis: [f64; 3],
        /// Radius, length.
        #[unit(length)]
        #[schemars(extend("exclusiveMinimum" = 0))]
        radius: f64,
        /// True if the bodies are inside.
        #[serde(default)]
        inside: bool,
        /// Place that carries the obstacle; the ground by default.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        on: Option<Place>,
    },
    /// Contact of the bodies with each other and of each body with itself.
    Bodies,
}

impl Against {
    /// Place that carries an obstacle, if not the ground.
    pub const fn on(&self) -> Option<&Place> {
        match self {
            Self::Plane { on, .. } | Self::Sphere { on, .. } | Self::Cylinder { on, .. } => on.as_ref(),
            Self::Bodies => None,
        }
    }
}
