use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::function::Clock;
use super::{Place, TimeFunction};
use crate::mechanics::{BeamMesh, FollowerForce, Force, Moment};
use crate::system::Term;

/// A load on a body. Gravity is a property of the model.
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

    /// Where it acts.
    pub const fn on(&self) -> &Place {
        match self {
            Self::Force { on, .. } | Self::Moment { on, .. } => on,
        }
    }

    /// Whether it turns with the section.
    pub const fn is_follower(&self) -> bool {
        match self {
            Self::Force { follower, .. } | Self::Moment { follower, .. } => *follower,
        }
    }

    /// Its function of time.
    pub const fn time(&self) -> &TimeFunction {
        match self {
            Self::Force { time, .. } | Self::Moment { time, .. } => time,
        }
    }

    /// The load on a mesh at an arc length.
    pub(super) fn term(&self, mesh: &BeamMesh, s: f64, clock: Clock) -> Box<dyn Term> {
        let function = clock.function(self.time());
        let [_, d, e] = mesh.axes(s);
        match self {
            Self::Force { force, follower: false, .. } => {
                Box::new(Force::varying(&mesh.point(s), Vector3::from(*force), function))
            }
            Self::Force { force, follower: true, .. } => {
                let point = mesh.point(s);
                Box::new(FollowerForce::new(&point, [&d, &e], Vector3::from(*force), function))
            }
            Self::Moment { moment, follower: false, .. } => {
                Box::new(Moment::new([&d, &e], Vector3::from(*moment), function))
            }
            Self::Moment { moment, follower: true, .. } => {
                Box::new(Moment::follower([&d, &e], Vector3::from(*moment), function))
            }
        }
    }
}
