use ancf_mechanics::functions::ForceFunction;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::fluid::Fluid;
use crate::model::bodies::{At, Named, Place};
use crate::model::functions::TimeFunction;
use crate::units::Scales;

/// A load on bodies. Gravity is a property of the model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Load {
    /// A force on a point of the axis.
    Force {
        /// Where it acts.
        on: Place,
        /// The force in the global frame; of a follower, in the undeformed state.
        force: [f64; 3],
        /// Whether it turns with the section.
        #[serde(default)]
        follower: bool,
        /// Function of time by which it is multiplied; statics ignores it.
        #[serde(default)]
        time: TimeFunction,
    },
    /// A moment on a section.
    Moment {
        /// Where it acts.
        on: Place,
        /// The moment in the global frame; of a follower, in the undeformed state.
        moment: [f64; 3],
        /// Whether it turns with the section.
        #[serde(default)]
        follower: bool,
        /// Function of time by which it is multiplied; statics ignores it.
        #[serde(default)]
        time: TimeFunction,
    },
    /// A force per length along an axis.
    DistributedForce {
        /// Name of the body.
        body: String,
        /// Where it begins; at the start of the body by default.
        #[serde(default = "start")]
        from: At,
        /// Where it ends; at the end of the body by default.
        #[serde(default = "end")]
        to: At,
        /// The force per undeformed length, in the global frame; of a follower, in that of each section.
        force: [f64; 3],
        /// Likewise at `to`, if it varies: linearly, from `force` at `from`.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        force_end: Option<[f64; 3]>,
        /// Whether it turns with the sections.
        #[serde(default)]
        follower: bool,
        /// Function of time by which it is multiplied; statics ignores it.
        #[serde(default)]
        time: TimeFunction,
    },
    /// A moment per length on the sections of a beam.
    DistributedMoment {
        /// Name of the body.
        body: String,
        /// Where it begins; at the start of the body by default.
        #[serde(default = "start")]
        from: At,
        /// Where it ends; at the end of the body by default.
        #[serde(default = "end")]
        to: At,
        /// The moment per undeformed length, in the global frame; of a follower, in that of each section.
        moment: [f64; 3],
        /// Likewise at `to`, if it varies: linearly, from `moment` at `from`.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        moment_end: Option<[f64; 3]>,
        /// Whether it turns with the sections.
        #[serde(default)]
        follower: bool,
        /// Function of time by which it is multiplied; statics ignores it.
        #[serde(default)]
        time: TimeFunction,
    },
    /// The ground accelerates without turning; all that is computed is relative to it.
    BaseAcceleration {
        /// Acceleration of the ground, length/time².
        acceleration: [f64; 3],
        /// Function of time by which it is multiplied; statics ignores it.
        #[serde(default)]
        time: TimeFunction,
    },
    /// A fluid around bodies: drag, added mass and buoyancy.
    Fluid(Fluid),
    /// A force on a point that the program computes from time, position and velocity of the point; the command line has none.
    /// In statics the velocity is 0, the time 1.
    External {
        /// Where it acts.
        on: Place,
        /// The name under which the program supplies it.
        #[schemars(length(min = 1))]
        name: String,
        /// What the model's units of length, time and force are in those of the function; the same by default.
        #[serde(default = "own")]
        units: Scales,
        /// The function, once it is supplied ([`Model::supply_force`](crate::model::Model::supply_force)).
        #[serde(skip)]
        #[schemars(skip)]
        supplied: Option<ForceFunction>,
    },
}

fn own() -> Scales {
    Scales::UNIT
}

fn start() -> At {
    At::Named(Named::Start)
}

fn end() -> At {
    At::Named(Named::End)
}

/// Part of a body, and a load per length at its two ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stretch<'a> {
    pub body: &'a str,
    pub from: At,
    pub to: At,
    pub loads: [[f64; 3]; 2],
}

impl Load {
    /// A force of constant size and direction.
    pub fn force(on: Place, force: [f64; 3]) -> Self {
        Self::Force { on, force, follower: false, time: TimeFunction::default() }
    }

    /// A moment of constant size and direction.
    pub fn moment(on: Place, moment: [f64; 3]) -> Self {
        Self::Moment { on, moment, follower: false, time: TimeFunction::default() }
    }

    /// A force that the program supplies under a name.
    pub fn external(on: Place, name: &str) -> Self {
        Self::External { on, name: name.into(), units: Scales::UNIT, supplied: None }
    }

    /// The place where it acts, if it acts at one.
    pub const fn on(&self) -> Option<&Place> {
        match self {
            Self::Force { on, .. } | Self::Moment { on, .. } | Self::External { on, .. } => Some(on),
            _ => None,
        }
    }

    /// Where a load per length acts.
    pub(crate) fn stretch(&self) -> Option<Stretch<'_>> {
        match self {
            Self::DistributedForce { body, from, to, force: load, force_end: last, .. }
            | Self::DistributedMoment { body, from, to, moment: load, moment_end: last, .. } => {
                Some(Stretch { body, from: *from, to: *to, loads: [*load, last.unwrap_or(*load)] })
            }
            _ => None,
        }
    }

    /// Whether it turns with the section.
    pub const fn is_follower(&self) -> bool {
        match self {
            Self::Force { follower, .. }
            | Self::Moment { follower, .. }
            | Self::DistributedForce { follower, .. }
            | Self::DistributedMoment { follower, .. } => *follower,
            Self::BaseAcceleration { .. } | Self::Fluid(_) | Self::External { .. } => false,
        }
    }

    /// Whether it is a moment, at a place or per length.
    pub const fn is_moment(&self) -> bool {
        matches!(self, Self::Moment { .. } | Self::DistributedMoment { .. })
    }

    /// Its function of time, if it has one.
    pub const fn time(&self) -> Option<&TimeFunction> {
        match self {
            Self::Force { time, .. }
            | Self::Moment { time, .. }
            | Self::DistributedForce { time, .. }
            | Self::DistributedMoment { time, .. }
            | Self::BaseAcceleration { time, .. }
            | Self::Fluid(Fluid { time, .. }) => Some(time),
            Self::External { .. } => None,
        }
    }

    /// The same to be changed.
    pub(crate) const fn time_mut(&mut self) -> Option<&mut TimeFunction> {
        match self {
            Self::Force { time, .. }
            | Self::Moment { time, .. }
            | Self::DistributedForce { time, .. }
            | Self::DistributedMoment { time, .. }
            | Self::BaseAcceleration { time, .. }
            | Self::Fluid(Fluid { time, .. }) => Some(time),
            Self::External { .. } => None,
        }
    }
}
