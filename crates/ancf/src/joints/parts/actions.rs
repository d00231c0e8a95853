//! Drives, springs with dampers, and friction along a free coordinate of a joint.

use ancf_mechanics::constraints::MeasureTarget;
use ancf_mechanics::functions::Function;
use ancf_mechanics::laws::{ContactLaw, Stops};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::friction::{AngularFriction, JointFriction, LinearFriction};
use crate::model::{JointLaw, LawKind, LawUse, TimeFunction, TimeMode};
use crate::units::Scaled;

/// Prescribed angle of a joint, by `angle` or by `rate`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct AngularDrive {
    /// Angle, in radians. The function of time multiplies it.
    #[unit(radian)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angle: Option<f64>,
    /// Angular velocity, radians/time. The function of time multiplies it.
    #[unit(radian / time)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rate: Option<f64>,
    /// Function of time; 1 by default. In statics the load factor multiplies `angle`, and `rate` has no effect.
    #[serde(default)]
    pub time: TimeFunction,
}

/// Prescribed displacement of a joint, by `displacement` or by `speed`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct LinearDrive {
    /// Displacement, length. The function of time multiplies it.
    #[unit(length)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub displacement: Option<f64>,
    /// Velocity, length/time. The function of time multiplies it.
    #[unit(length / time)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub speed: Option<f64>,
    /// Function of time; 1 by default. In statics the load factor multiplies `displacement`, and `speed` has no effect.
    #[serde(default)]
    pub time: TimeFunction,
}

/// Torsion spring and damper with the moment −stiffness (θ − angle) − damping dθ/dt.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct AngularSpring {
    /// Stiffness, force length/radian.
    #[serde(default)]
    #[unit(force * length / radian)]
    #[schemars(extend("minimum" = 0))]
    pub stiffness: f64,
    /// Damping, force length time/radian.
    #[serde(default)]
    #[unit(force * length * time / radian)]
    #[schemars(extend("minimum" = 0))]
    pub damping: f64,
    /// Angle at which the spring moment is zero, in radians; 0 by default.
    #[serde(default)]
    #[unit(radian)]
    pub angle: f64,
}

/// Spring and damper with the force −stiffness (s − displacement) − damping ds/dt.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct LinearSpring {
    /// Stiffness, force/length.
    #[serde(default)]
    #[unit(force / length)]
    #[schemars(extend("minimum" = 0))]
    pub stiffness: f64,
    /// Damping, force time/length.
    #[serde(default)]
    #[unit(force * time / length)]
    #[schemars(extend("minimum" = 0))]
    pub damping: f64,
    /// Displacement at which the spring force is zero, length; 0 by default.
    #[serde(default)]
    #[unit(length)]
    pub displacement: f64,
}

/// Stops of an angle: one-sided contact at a lower and an upper angle.
///
/// The moment is p h with p = k d²/(2 δ) for depths d below δ, k (d − δ/2) beyond, and h = √(1 + (c dd/dt)²) + c dd/dt.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct AngularStops {
    /// Lower stop, in radians; none by default.
    #[unit(radian)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lower: Option<f64>,
    /// Upper stop, in radians; none by default.
    #[unit(radian)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub upper: Option<f64>,
    /// Stiffness k, force length/radian.
    #[unit(force * length / radian)]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub stiffness: f64,
    /// Depth δ over which the stiffness increases from zero, in radians.
    #[unit(radian)]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub transition: f64,
    /// Damping c, time/radian; none by default.
    #[unit(time / radian)]
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub damping: f64,
}

/// Stops of a displacement: one-sided contact at a lower and an upper displacement.
///
/// The force is p h with p = k d²/(2 δ) for depths d below δ, k (d − δ/2) beyond, and h = √(1 + (c dd/dt)²) + c dd/dt.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct LinearStops {
    /// Lower stop, length; none by default.
    #[unit(length)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lower: Option<f64>,
    /// Upper stop, length; none by default.
    #[unit(length)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub upper: Option<f64>,
    /// Stiffness k, force/length.
    #[unit(force / length)]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub stiffness: f64,
    /// Depth δ over which the stiffness increases from zero, length.
    #[unit(length)]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub transition: f64,
    /// Damping c, time/length; none by default.
    #[unit(time / length)]
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub damping: f64,
}

impl AngularStops {
    /// Force law of the stops.
    pub(crate) const fn law(&self) -> Stops {
        stops([self.lower, self.upper], [self.stiffness, self.transition, self.damping])
    }
}

impl LinearStops {
    /// Force law of the stops.
    pub(crate) const fn law(&self) -> Stops {
        stops([self.lower, self.upper], [self.stiffness, self.transition, self.damping])
    }
}

const fn stops(at: [Option<f64>; 2], [stiffness, transition, damping]: [f64; 3]) -> Stops {
    // Without friction, the slip speed has no effect.
    Stops { at, law: ContactLaw { stiffness, transition, damping, friction: 0.0, slip_speed: 1.0 } }
}

/// Drive, spring, friction, force law and stops along a free angle or displacement of a joint.
#[derive(Clone, Copy, Debug, Default)]
pub struct JointActions<'a> {
    /// Table that states the drive: `"drive"` or `"feed"`.
    pub table: &'static str,
    /// Prescribed motion.
    pub drive: Option<PrescribedMotion<'a>>,
    /// Stiffness, damping and position without spring force.
    pub spring: Option<[f64; 3]>,
    /// Dry friction.
    pub friction: Option<JointFriction>,
    /// Force law.
    pub law: Option<LawUse<'a>>,
    /// Stops.
    pub stops: Option<Stops>,
}

/// Prescribed angle or displacement.
#[derive(Clone, Copy, Debug)]
pub struct PrescribedMotion<'a> {
    /// Factor of the coordinate, or of its rate.
    pub amounts: [Option<f64>; 2],
    /// Function of time.
    pub time: &'a TimeFunction,
}

impl JointActions<'_> {
    /// True if there is a drive, a spring, friction or a force law.
    pub(crate) const fn is_some(&self) -> bool {
        self.drive.is_some()
            || self.spring.is_some()
            || self.friction.is_some()
            || self.law.is_some()
            || self.stops.is_some()
    }
}

impl<'a> JointActions<'a> {
    /// Adds stops.
    #[must_use]
    pub(crate) fn with_stops(self, stops: Option<Stops>) -> Self {
        Self { stops, ..self }
    }

    /// Adds a force law.
    #[must_use]
    pub(crate) fn with_law(self, law: &'a Option<JointLaw>, kind: LawKind) -> Self {
        Self { law: law.as_ref().map(|law| LawUse::new(law, kind)), ..self }
    }

    /// Drive, spring and friction along an angle.
    pub(crate) fn along_angle(
        drive: &'a Option<AngularDrive>,
        spring: &Option<AngularSpring>,
        friction: &Option<AngularFriction>,
    ) -> Self {
        let motion = |d: &'a AngularDrive| PrescribedMotion { amounts: [d.angle, d.rate], time: &d.time };
        Self {
            table: "drive",
            drive: drive.as_ref().map(motion),
            spring: spring.map(|s| [s.stiffness, s.damping, s.angle]),
            friction: friction.map(AngularFriction::law),
            law: None,
            stops: None,
        }
    }

    /// Drive, spring and friction along a displacement.
    pub(crate) fn along_displacement(
        drive: &'a Option<LinearDrive>,
        spring: &Option<LinearSpring>,
        friction: &Option<LinearFriction>,
    ) -> Self {
        let motion =
            |d: &'a LinearDrive| PrescribedMotion { amounts: [d.displacement, d.speed], time: &d.time };
        Self {
            table: "drive",
            drive: drive.as_ref().map(motion),
            spring: spring.map(|s| [s.stiffness, s.damping, s.displacement]),
            friction: friction.map(LinearFriction::law),
            law: None,
            stops: None,
        }
    }
}

impl PrescribedMotion<'_> {
    /// True for a rate in statics, which is zero: the value remains that of the start.
    pub(crate) fn is_held(&self, time_mode: TimeMode) -> bool {
        matches!(self.amounts, [None, Some(_)]) && time_mode != TimeMode::AsGiven
    }

    /// Prescribed value as a function of time: as stated, or the integral of the stated rate. In statics the rate is zero.
    pub(crate) fn target(&self, time_mode: TimeMode) -> MeasureTarget {
        match self.amounts {
            [Some(amount), _] => MeasureTarget::new(amount, time_mode.function(self.time)),
            [None, Some(rate)] if time_mode == TimeMode::AsGiven => {
                let integral = time_mode.function(self.time).integral();
                MeasureTarget::new(
                    rate,
                    integral.expect("a checked model prescribes rates that can be integrated"),
                )
            }
            _ => MeasureTarget::new(0.0, Function::ONE),
        }
    }
}
