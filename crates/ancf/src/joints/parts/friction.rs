//! Dry friction of joints: of a given magnitude, and in proportion to the reaction.

use ancf_mechanics::laws::FrictionCurve;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Scaled;

/// Dry friction of a hinge with the moment −(moment + coefficient radius N) g(ω).
///
/// N is the normal force of the reaction, g(ω) = tanh(ω/rate) (1 + (peak − 1) exp(−(ω/decay)²)).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct AngularFriction {
    /// Friction moment without a reaction, such as that of a seal, force length; 0 by default.
    #[unit(force * length)]
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub moment: f64,
    /// Angular velocity below which friction is viscous, radians/time.
    #[unit(radian / time)]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub rate: f64,
    /// Coefficient of friction of the bearing; 0 by default.
    #[unit(number)]
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub coefficient: f64,
    /// Radius of the pin, on which the reaction across the axis acts, length. Required with a coefficient.
    #[unit(length)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: Option<f64>,
    /// Distance of two bearings that carry the reaction moments, length. Without it these moments cause no friction.
    #[unit(length)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub span: Option<f64>,
    /// Mean radius of a collar that carries the reaction along the axis, length. Without it this force causes no friction.
    #[unit(length)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub collar: Option<f64>,
    /// Ratio of the largest friction at low rates to that at high rates (Stribeck); 1 by default.
    #[unit(number)]
    #[serde(default = "one")]
    #[schemars(extend("minimum" = 1))]
    pub peak: f64,
    /// Angular velocity over which friction falls from its peak, radians/time. Required with a peak above 1.
    #[unit(radian / time)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub decay: Option<f64>,
}

/// Dry friction of a slider with the force −(force + coefficient N) g(v).
///
/// N is the normal force of the reaction, g(v) = tanh(v/speed) (1 + (peak − 1) exp(−(v/decay)²)).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct LinearFriction {
    /// Friction force without a reaction, force; 0 by default.
    #[unit(force)]
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub force: f64,
    /// Velocity below which friction is viscous, length/time.
    #[unit(length / time)]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub speed: f64,
    /// Coefficient of friction of the guide; 0 by default.
    #[unit(number)]
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub coefficient: f64,
    /// Distance of two shoes that carry the reaction moments across the axis, length. Without it these moments cause no friction.
    #[unit(length)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub span: Option<f64>,
    /// Lever arm at which the guide carries the moment about the axis, length. Without it this moment causes no friction.
    #[unit(length)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub arm: Option<f64>,
    /// Ratio of the largest friction at low velocities to that at high ones (Stribeck); 1 by default.
    #[unit(number)]
    #[serde(default = "one")]
    #[schemars(extend("minimum" = 1))]
    pub peak: f64,
    /// Velocity over which friction falls from its peak, length/time. Required with a peak above 1.
    #[unit(length / time)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub decay: Option<f64>,
}

/// Dry friction along an angle or a displacement of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointFriction {
    /// Magnitude without a reaction.
    pub amount: f64,
    /// Coefficient of friction.
    pub coefficient: f64,
    /// Dependence on the rate.
    pub curve: FrictionCurve,
    /// Radius of a pin.
    pub radius: Option<f64>,
    /// Distance of two bearings or shoes.
    pub span: Option<f64>,
    /// Radius of a collar, or lever arm of a guide.
    pub arm: Option<f64>,
    /// True if the decay from a peak is stated.
    pub has_decay: bool,
}

impl JointFriction {
    /// Friction of a given magnitude, viscous below a rate.
    pub const fn constant(amount: f64, rate: f64) -> Self {
        let curve = FrictionCurve::flat(rate);
        Self { amount, coefficient: 0.0, curve, radius: None, span: None, arm: None, has_decay: false }
    }
}

const fn one() -> f64 {
    1.0
}

fn curve(creep: f64, peak: f64, decay: Option<f64>) -> FrictionCurve {
    FrictionCurve { creep, peak, decay: decay.unwrap_or(creep) }
}

impl AngularFriction {
    pub(crate) fn law(self) -> JointFriction {
        JointFriction {
            amount: self.moment,
            coefficient: self.coefficient,
            curve: curve(self.rate, self.peak, self.decay),
            radius: self.radius,
            span: self.span,
            arm: self.collar,
            has_decay: self.decay.is_some(),
        }
    }
}

impl LinearFriction {
    pub(crate) fn law(self) -> JointFriction {
        JointFriction {
            amount: self.force,
            coefficient: self.coefficient,
            curve: curve(self.speed, self.peak, self.decay),
            radius: None,
            span: self.span,
            arm: self.arm,
            has_decay: self.decay.is_some(),
        }
    }
}
