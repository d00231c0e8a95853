use ancf_mechanics::functions::ForceFunction;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::custom::CustomLoad;
use super::fluid::Fluid;
use crate::model::bodies::{At, NamedPosition, Place};
use crate::model::functions::TimeFunction;
use crate::units::{Scaled, Scales};

/// Load on bodies. Gravity is a key of the model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Load {
    /// Force at a point of a body.
    Force {
        /// Point of application.
        on: Place,
        /// Force vector in the global frame, of a follower in the undeformed state; force.
        #[unit(force)]
        force: [f64; 3],
        /// True for a load that rotates with the section.
        #[serde(default)]
        follower: bool,
        /// Function of time that multiplies the load. Statics ignores it.
        #[serde(default)]
        time: TimeFunction,
    },
    /// Moment on a section or on a rigid body.
    Moment {
        /// Point of application.
        on: Place,
        /// Moment vector in the global frame, of a follower in the undeformed state; force length.
        #[unit(force * length)]
        moment: [f64; 3],
        /// True for a load that rotates with the section.
        #[serde(default)]
        follower: bool,
        /// Function of time that multiplies the load. Statics ignores it.
        #[serde(default)]
        time: TimeFunction,
    },
    /// Force per length along the axis of a body.
    DistributedForce {
        /// Name of the body.
        body: String,
        /// Start of the load; the start of the axis by default.
        #[serde(default = "start")]
        from: At,
        /// End of the load; the end of the axis by default.
        #[serde(default = "end")]
        to: At,
        /// Force per undeformed length in the global frame, of a follower in the frame of each section; force/length.
        #[unit(force / length)]
        force: [f64; 3],
        /// Force per undeformed length at `to`, force/length. The load varies linearly from `force` at `from`. Constant by
        /// default.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[unit(force / length)]
        force_end: Option<[f64; 3]>,
        /// True for a load that rotates with the sections.
        #[serde(default)]
        follower: bool,
        /// Function of time that multiplies the load. Statics ignores it.
        #[serde(default)]
        time: TimeFunction,
    },
    /// Moment per length on the sections of a beam.
    DistributedMoment {
        /// Name of the body.
        body: String,
        /// Start of the load; the start of the axis by default.
        #[serde(default = "start")]
        from: At,
        /// End of the load; the end of the axis by default.
        #[serde(default = "end")]
        to: At,
        /// Moment per undeformed length in the global frame, of a follower in the frame of each section; force.
        #[unit(force)]
        moment: [f64; 3],
        /// Moment per undeformed length at `to`, force. The load varies linearly from `moment` at `from`. Constant by default.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[unit(force)]
        moment_end: Option<[f64; 3]>,
        /// True for a load that rotates with the sections.
        #[serde(default)]
        follower: bool,
        /// Function of time that multiplies the load. Statics ignores it.
        #[serde(default)]
        time: TimeFunction,
    },
    /// Translational acceleration of the ground. All results are relative to the ground.
    BaseAcceleration {
        /// Acceleration of the ground, length/time².
        #[unit(length / time^2)]
        acceleration: [f64; 3],
        /// Function of time that multiplies the load. Statics ignores it.
        #[serde(default)]
        time: TimeFunction,
    },
    /// Fluid around bodies: drag, added mass and buoyancy.
    Fluid(Fluid),
    /// Force at a point, computed by a function of time, position and velocity of the point.
    ///
    /// The calling program supplies the function; the command line has none. In statics the velocity is 0 and the time is 1.
    External {
        /// Point of application.
        on: Place,
        /// The name under which the program supplies it.
        #[schemars(length(min = 1))]
        name: String,
        /// Units of length, time and force of the model, measured in units of the function; equal by default.
        #[serde(default = "own")]
        units: Scales,
        /// The supplied function ([`Model::supply_force`](crate::model::Model::supply_force)).
        #[serde(skip)]
        #[unit(none)]
        #[schemars(skip)]
        supplied: Option<ForceFunction>,
    },
    /// A load of a kind that a program adds; model files have none.
    #[serde(skip)]
    #[schemars(skip)]
    Custom(CustomLoad),
}

fn own() -> Scales {
    Scales::UNIT
}

fn start() -> At {
    At::Named(NamedPosition::Start)
}

fn end() -> At {
    At::Named(NamedPosition::End)
}

/// Part of a body, with a load per length at its two ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stretch<'a> {
    pub body: &'a str,
    pub from: At,
    pub to: At,
    pub loads: [[f64; 3]; 2],
}

impl Load {
    /// Force of constant magnitude and direction.
    pub fn force(on: Place, force: [f64; 3]) -> Self {
        Self::Force { on, force, follower: false, time: TimeFunction::default() }
    }

    /// Moment of constant magnitude and direction.
    pub fn moment(on: Place, moment: [f64; 3]) -> Self {
        Self::Moment { on, moment, follower: false, time: TimeFunction::default() }
    }

    /// Force by a function that the calling program supplies under a name.
    pub fn external(on: Place, name: &str) -> Self {
        Self::External { on, name: name.into(), units: Scales::UNIT, supplied: None }
    }

    /// Point of application of a concentrated load.
    pub fn on(&self) -> Option<&Place> {
        match self {
            Self::Force { on, .. } | Self::Moment { on, .. } | Self::External { on, .. } => Some(on),
            Self::Custom(load) => Some(load.kind().on()),
            _ => None,
        }
    }

    /// Loaded part of a body, of a load per length.
    pub(crate) fn stretch(&self) -> Option<Stretch<'_>> {
        match self {
            Self::DistributedForce { body, from, to, force: load, force_end: last, .. }
            | Self::DistributedMoment { body, from, to, moment: load, moment_end: last, .. } => {
                Some(Stretch { body, from: *from, to: *to, loads: [*load, last.unwrap_or(*load)] })
            }
            _ => None,
        }
    }

    /// True for a load that rotates with the section.
    pub const fn is_follower(&self) -> bool {
        match self {
            Self::Force { follower, .. }
            | Self::Moment { follower, .. }
            | Self::DistributedForce { follower, .. }
            | Self::DistributedMoment { follower, .. } => *follower,
            Self::BaseAcceleration { .. } | Self::Fluid(_) | Self::External { .. } | Self::Custom(_) => false,
        }
    }

    /// True for moments and moments per length.
    pub const fn is_moment(&self) -> bool {
        matches!(self, Self::Moment { .. } | Self::DistributedMoment { .. })
    }

    /// Function of time, if the load has one.
    pub fn time(&self) -> Option<&TimeFunction> {
        match self {
            Self::Force { time, .. }
            | Self::Moment { time, .. }
            | Self::DistributedForce { time, .. }
            | Self::DistributedMoment { time, .. }
            | Self::BaseAcceleration { time, .. }
            | Self::Fluid(Fluid { time, .. }) => Some(time),
            Self::External { .. } => None,
            Self::Custom(load) => load.kind().time(),
        }
    }

    /// Mutable function of time, if the load has one.
    pub(crate) const fn time_mut(&mut self) -> Option<&mut TimeFunction> {
        match self {
            Self::Force { time, .. }
            | Self::Moment { time, .. }
            | Self::DistributedForce { time, .. }
            | Self::DistributedMoment { time, .. }
            | Self::BaseAcceleration { time, .. }
            | Self::Fluid(Fluid { time, .. }) => Some(time),
            Self::External { .. } | Self::Custom(_) => None,
        }
    }
}
