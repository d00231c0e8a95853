use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::function::Clock;
use super::{Place, TimeFunction};
use crate::mechanics::{Attachment, FollowerForce, Force, Moment};
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

    /// The load on a place.
    pub(super) fn term(&self, on: &Attachment, clock: Clock) -> Box<dyn Term> {
        let (point, function) = (&on.point, clock.function(self.time()));
        // Moments and followers are refused where there are no directions.
        let directors = on.axes().map(|[_, d, e]| [d, e]);
        match (self, directors) {
            (Self::Force { force, follower: true, .. }, Some(directors)) => {
                Box::new(FollowerForce::new(point, directors, Vector3::from(*force), function))
            }
            (Self::Moment { moment, follower: true, .. }, Some(directors)) => {
                Box::new(Moment::follower(directors, Vector3::from(*moment), function))
            }
            (Self::Moment { moment, .. }, Some(directors)) => {
                Box::new(Moment::new(directors, Vector3::from(*moment), function))
            }
            (Self::Force { force: load, .. } | Self::Moment { moment: load, .. }, _) => {
                Box::new(Force::varying(point, Vector3::from(*load), function))
            }
        }
    }
}
