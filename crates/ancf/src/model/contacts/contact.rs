use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::surface::ContactSurface;
use crate::units::Scaled;

/// Contact of bodies with an obstacle or with each other. Beams and cables are round tubes about their axes, and shells have their
/// thickness. Rigid bodies and point masses have the surface that they state. They touch obstacles only.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Contact {
    /// Contact partner of the bodies.
    pub with: ContactSurface,
    /// Names of the beams, cables and shells, and of bodies with a `surface`; all except the body that carries the obstacle by default.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub bodies: Vec<String>,
    /// Radius of the beams and cables, length; that of circles and tubes by default.
    #[unit(length)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: Option<f64>,
    /// Contact points of each element, of a shell in each direction and odd; by default a number that resolves the obstacle and the radius.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 1, max = 10000))]
    pub points: Option<u32>,
    /// Force per length of a body and per depth, force/length²; required with bodies other than shells.
    #[unit(force / length^2)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub stiffness: Option<f64>,
    /// Pressure on a shell per depth, force/length³; required with shells.
    #[unit(force / length^3)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub surface_stiffness: Option<f64>,
    /// Depth over which the stiffness grows from zero, length; 1/50 of the smallest radius or half thickness by default.
    #[unit(length)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub transition: Option<f64>,
    /// Damping coefficient c, time/length. The factor of the force is 1 − c v for small velocities v of separation.
    #[unit(time / length)]
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub damping: f64,
    /// Coefficient of friction; 0 by default. Equilibria admit no friction.
    #[serde(default)]
    #[unit(number)]
    #[schemars(extend("minimum" = 0))]
    pub friction: f64,
    /// Sliding speed below which friction is viscous, length/time; by default 1/1000 of the length of the longest flexible body, or
    /// of the extent of a model without flexible bodies, divided by the duration.
    #[unit(length / time)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub slip_speed: Option<f64>,
}
