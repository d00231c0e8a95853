//! Dry friction of joints: of a given magnitude, and in proportion to the reaction.

use ancf_mechanics::bodies::normals_to;
use ancf_mechanics::forces::{Bearing, FrictionLaw, ReactionFriction, Slip, TurnAxis};
use ancf_mechanics::kinematics::{Attachment, BodyVector};
use ancf_mechanics::laws::FrictionCurve;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::builder::JointBuilder;
use super::measures;
use crate::units::Scaled;

/// Dry friction of a hinge, ball joint or cross: moment −(moment + coefficient radius N) g(ω).
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
    /// Radius of the pin or ball, on which the reaction acts, length. Required with a coefficient.
    #[unit(length)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: Option<f64>,
    /// Distance of two bearings that carry the reaction moments, length. Without it these moments cause no friction. Not of balls.
    #[unit(length)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub span: Option<f64>,
    /// Mean radius of a collar that carries the reaction along the axis, length. Without it this force causes no friction. Of hinges.
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

/// Dry friction of a slider, a shaft or a plane with the force −(force + coefficient N) g(v).
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
    /// Radius of a shaft that slides and turns, length. Required by cylindrical joints, and only of these.
    #[unit(length)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: Option<f64>,
    /// Distance of two shoes that carry the reaction moments across the axis, length. Without it these moments cause no friction. Of prismatic
    /// and cylindrical joints.
    #[unit(length)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub span: Option<f64>,
    /// Lever arm at which the guide carries the moment about the axis, length. Without it this moment causes no friction. Of prismatic joints.
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
    /// Key of the radius of a collar or of the lever arm.
    pub arm_key: &'static str,
    /// True if the decay from a peak is stated.
    pub has_decay: bool,
}

impl JointFriction {
    /// Friction of a given magnitude, viscous below a rate.
    pub const fn constant(amount: f64, rate: f64) -> Self {
        let curve = FrictionCurve::flat(rate);
        let (radius, span, arm) = (None, None, None);
        Self { amount, coefficient: 0.0, curve, radius, span, arm, arm_key: "arm", has_decay: false }
    }

    /// Lengths that are stated, with their keys.
    pub(crate) fn lengths(&self) -> impl Iterator<Item = (&'static str, f64)> {
        let lengths = [("radius", self.radius), ("span", self.span), (self.arm_key, self.arm)];
        lengths.into_iter().filter_map(|(key, length)| Some((key, length?)))
    }

    fn law(&self) -> FrictionLaw {
        FrictionLaw { amount: self.amount, coefficient: self.coefficient, curve: self.curve }
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
            arm_key: "collar",
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
            radius: self.radius,
            span: self.span,
            arm: self.arm,
            arm_key: "arm",
            has_decay: self.decay.is_some(),
        }
    }
}

/// Axes of a triad.
const AXES: [Vector3<f64>; 3] =
    [Vector3::new(1.0, 0.0, 0.0), Vector3::new(0.0, 1.0, 0.0), Vector3::new(0.0, 0.0, 1.0)];

impl JointBuilder<'_> {
    /// Adds friction along components of slip. The first equations of the joint are those of the bearing.
    pub(super) fn add_friction(&mut self, slip: Vec<Slip>, bearing: Bearing, friction: &JointFriction) {
        let first = self.equations.multipliers.start;
        self.add(ReactionFriction::new(slip, first, bearing, friction.law()));
    }

    /// Component of the relative angular velocity of both ends, times a lever arm.
    fn turn(&self, axis: TurnAxis, arm: f64) -> Slip {
        let triad = |end: &Attachment| AXES.map(|axis| end.direction(axis));
        Slip::Turn { triads: Box::new([triad(self.a()), triad(self.b())]), axis, arm }
    }

    /// Adds friction of a ball.
    pub(crate) fn add_ball_friction(&mut self, friction: &JointFriction) {
        let turn = |axis| self.turn(TurnAxis::Direction(BodyVector::fixed(axis)), 1.0);
        let slip = AXES.map(turn).into();
        self.add_friction(slip, Bearing::Ball { radius: friction.radius.unwrap_or(0.0) }, friction);
    }

    /// Adds friction of the arms of a cross.
    pub(crate) fn add_cross_friction(&mut self, [a, b]: [Vector3<f64>; 2], friction: &JointFriction) {
        let arms = [self.a().direction(a), self.b().direction(b)];
        let [a, b] = &arms;
        for (own, other) in [(a, b), (b, a)] {
            let arms = Box::new([own.clone(), other.clone()]);
            let radius = friction.radius.unwrap_or(0.0);
            let bearing = Bearing::Arm { arms: arms.clone(), radius, span: friction.span };
            let slip = self.turn(TurnAxis::ArmOfCross(arms), 1.0);
            self.add_friction(vec![slip], bearing, friction);
        }
    }

    /// Adds friction of a shaft that turns and slides in a sleeve.
    pub(crate) fn add_sleeve_friction(&mut self, axis: Vector3<f64>, friction: &JointFriction) {
        let along = Slip::Rate(measures::along(self.a(), self.b(), axis));
        let direction = TurnAxis::Direction(self.b().direction(axis));
        let about = self.turn(direction, friction.radius.unwrap_or(0.0));
        self.add_friction(vec![along, about], Bearing::Sleeve { span: friction.span }, friction);
    }

    /// Adds friction of a point on a line.
    pub(crate) fn add_line_friction(&mut self, axis: Vector3<f64>, friction: &JointFriction) {
        let slip = Slip::Rate(measures::along(self.a(), self.b(), axis));
        self.add_friction(vec![slip], Bearing::Line, friction);
    }

    /// Adds friction of a point on a plane.
    pub(crate) fn add_plane_friction(&mut self, normal: Vector3<f64>, friction: &JointFriction) {
        let along = |axis| Slip::Rate(measures::along(self.a(), self.b(), axis));
        let slip = normals_to(normal).map(along).into();
        self.add_friction(slip, Bearing::Plane, friction);
    }
}
