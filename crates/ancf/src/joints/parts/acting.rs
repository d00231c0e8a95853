//! What acts along a freedom of a joint: a drive, a spring with a damper, friction.

use ancf_mechanics::constraints::Target;
use ancf_mechanics::functions::Function;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::model::{Clock, TimeFunction};
use crate::units::{Dimension, Scales, number};

/// Prescribes the angle of a joint: by `angle` or by `rate`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AngularDrive {
    /// Angle by which the function of time is multiplied, in radians.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angle: Option<f64>,
    /// Angular velocity by which the function of time is multiplied, 1/time.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rate: Option<f64>,
    /// Function of time; 1 by default. Statics turns by `angle` with the load, and does not turn by `rate`.
    #[serde(default)]
    pub time: TimeFunction,
}

/// Prescribes the displacement of a joint: by `displacement` or by `speed`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinearDrive {
    /// Displacement by which the function of time is multiplied, length.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub displacement: Option<f64>,
    /// Velocity by which the function of time is multiplied, length/time.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub speed: Option<f64>,
    /// Function of time; 1 by default. Statics moves by `displacement` with the load, and does not move by `speed`.
    #[serde(default)]
    pub time: TimeFunction,
}

/// A torsion spring and a damper: the moment −stiffness (θ − angle) − damping dθ/dt.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AngularSpring {
    /// Stiffness, force length per radian.
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub stiffness: f64,
    /// Damping, force length time.
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub damping: f64,
    /// The angle at which the spring is free of moment, in radians; 0 by default.
    #[serde(default)]
    pub angle: f64,
}

/// A spring and a damper: the force −stiffness (s − displacement) − damping ds/dt.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinearSpring {
    /// Stiffness, force/length.
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub stiffness: f64,
    /// Damping, force time/length.
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub damping: f64,
    /// The displacement at which the spring is free of force, length; 0 by default.
    #[serde(default)]
    pub displacement: f64,
}

/// Dry friction of a hinge: the moment −moment tanh(ω/rate).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AngularFriction {
    /// Moment of the friction, force length.
    #[schemars(extend("minimum" = 0))]
    pub moment: f64,
    /// Angular velocity below which what should stick creeps, 1/time.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub rate: f64,
}

/// Dry friction of a slider: the force −force tanh(v/speed).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinearFriction {
    /// Force of the friction.
    #[schemars(extend("minimum" = 0))]
    pub force: f64,
    /// Velocity below which what should stick creeps, length/time.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub speed: f64,
}

/// What acts along one freedom, whatever its dimension.
#[derive(Clone, Copy, Debug, Default)]
pub struct Acting<'a> {
    /// Table that states the drive: `"drive"` or `"feed"`.
    pub(crate) table: &'static str,
    /// Prescribed motion.
    pub(crate) drive: Option<Led<'a>>,
    /// Stiffness, damping and set point.
    pub(crate) spring: Option<[f64; 3]>,
    /// Size and rate of creep.
    pub(crate) friction: Option<[f64; 2]>,
}

/// A prescribed freedom.
#[derive(Clone, Copy, Debug)]
pub struct Led<'a> {
    /// The freedom itself, or its rate.
    pub(crate) amounts: [Option<f64>; 2],
    pub(crate) time: &'a TimeFunction,
}

impl Acting<'_> {
    /// Whether there is anything.
    pub(crate) const fn is_some(&self) -> bool {
        self.drive.is_some() || self.spring.is_some() || self.friction.is_some()
    }
}

impl<'a> Acting<'a> {
    /// Along an angle.
    pub(crate) fn turning(
        drive: &'a Option<AngularDrive>,
        spring: &Option<AngularSpring>,
        friction: &Option<AngularFriction>,
    ) -> Self {
        let led = |d: &'a AngularDrive| Led { amounts: [d.angle, d.rate], time: &d.time };
        Self {
            table: "drive",
            drive: drive.as_ref().map(led),
            spring: spring.map(|s| [s.stiffness, s.damping, s.angle]),
            friction: friction.map(|f| [f.moment, f.rate]),
        }
    }

    /// Along a displacement.
    pub(crate) fn moving(
        drive: &'a Option<LinearDrive>,
        spring: &Option<LinearSpring>,
        friction: &Option<LinearFriction>,
    ) -> Self {
        let led = |d: &'a LinearDrive| Led { amounts: [d.displacement, d.speed], time: &d.time };
        Self {
            table: "drive",
            drive: drive.as_ref().map(led),
            spring: spring.map(|s| [s.stiffness, s.damping, s.displacement]),
            friction: friction.map(|f| [f.force, f.speed]),
        }
    }
}

impl Led<'_> {
    /// What the freedom is to be: stated, or the integral of the stated rate. In statics the rate is zero.
    pub(crate) fn target(&self, clock: Clock) -> Target {
        match self.amounts {
            [Some(amount), _] => Target::new(amount, clock.function(self.time)),
            [None, Some(rate)] if clock == Clock::Runs => {
                let integral = clock.function(self.time).integral();
                Target::new(rate, integral.expect("a checked model prescribes rates that can be integrated"))
            }
            _ => Target::new(0.0, Function::ONE),
        }
    }
}

impl AngularDrive {
    pub(crate) fn scaled(self, s: &Scales) -> Self {
        let Self { angle, rate, time } = self;
        Self { angle, rate: rate.map(|x| number(x, Dimension::RATE, s)), time: time.scaled(s) }
    }
}

impl LinearDrive {
    pub(crate) fn scaled(self, s: &Scales) -> Self {
        let Self { displacement, speed, time } = self;
        Self {
            displacement: displacement.map(|x| number(x, Dimension::LENGTH, s)),
            speed: speed.map(|x| number(x, Dimension::VELOCITY, s)),
            time: time.scaled(s),
        }
    }
}

impl AngularSpring {
    pub(crate) fn scaled(self, s: &Scales) -> Self {
        let Self { stiffness, damping, angle } = self;
        let stiffness = number(stiffness, Dimension::ENERGY, s);
        Self { stiffness, damping: number(damping, Dimension::new(1, 1, 1), s), angle }
    }
}

impl LinearSpring {
    pub(crate) fn scaled(self, s: &Scales) -> Self {
        let Self { stiffness, damping, displacement } = self;
        Self {
            stiffness: number(stiffness, Dimension::new(-1, 0, 1), s),
            damping: number(damping, Dimension::new(-1, 1, 1), s),
            displacement: number(displacement, Dimension::LENGTH, s),
        }
    }
}

impl AngularFriction {
    pub(crate) fn scaled(self, s: &Scales) -> Self {
        let Self { moment, rate } = self;
        Self { moment: number(moment, Dimension::ENERGY, s), rate: number(rate, Dimension::RATE, s) }
    }
}

impl LinearFriction {
    pub(crate) fn scaled(self, s: &Scales) -> Self {
        let Self { force, speed } = self;
        Self { force: number(force, Dimension::FORCE, s), speed: number(speed, Dimension::VELOCITY, s) }
    }
}
