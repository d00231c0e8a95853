use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::acting::{Acting, AngularDrive, AngularFriction, AngularSpring};
use super::end::End;
use super::joint_kinds::{
    Bushing, Cylindrical, Distance, Planar, PointOnLine, PointSpring, Prismatic, Slide, Universal,
};
use crate::model::bodies::Place;
use crate::model::functions::TimeFunction;

/// A joint between a body and the ground or another body.
///
/// Reactions are reported as the force and the moment that the joint exerts on its end `a`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Joint {
    /// Ties position and orientation.
    Clamp {
        /// Name in outputs and messages.
        #[schemars(length(min = 1))]
        name: String,
        /// The end that receives the reaction.
        a: Place,
        /// The other end; the ground by default.
        #[serde(default)]
        b: End,
        /// Which gradients are tied besides the position: `"all"` for beams of the continuum formulation, `"section"`
        /// for all else, by default.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        fix: Option<Clamped>,
    },
    /// A hinge: ties the position and leaves rotation about one axis.
    Revolute {
        /// Name in outputs and messages.
        #[schemars(length(min = 1))]
        name: String,
        /// The end that receives the reaction.
        a: Place,
        /// The other end; the ground by default.
        #[serde(default)]
        b: End,
        /// Direction of the axis in the undeformed state, in the global frame; its length does not matter.
        axis: [f64; 3],
        /// Prescribes the angle.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        drive: Option<AngularDrive>,
        /// A torsion spring and a damper.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        spring: Option<AngularSpring>,
        /// Dry friction.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        friction: Option<AngularFriction>,
    },
    /// A ball joint: ties the position.
    Spherical {
        /// Name in outputs and messages.
        #[schemars(length(min = 1))]
        name: String,
        /// The end that receives the reaction.
        a: Place,
        /// The other end; the ground by default.
        #[serde(default)]
        b: End,
    },
    /// A clamp to a frame that turns about the place and moves as it is told.
    Drive {
        /// Name in outputs and messages.
        #[schemars(length(min = 1))]
        name: String,
        /// The end that is led, and receives the reaction.
        a: Place,
        /// Direction of the axis in the global frame; its length does not matter. Without one the frame does not turn.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        axis: Option<[f64; 3]>,
        /// Angle by which the function of time is multiplied, in radians; 1 by default.
        #[serde(default = "one")]
        angle: f64,
        /// Displacement by which the function of time is multiplied, length; none by default.
        #[serde(default)]
        displacement: [f64; 3],
        /// Function of time; statics ignores it, turns and moves with the load.
        time: TimeFunction,
        /// Which gradients are tied besides the position, by default as those of a clamp.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        fix: Option<Clamped>,
    },
    /// Two shafts that meet.
    Universal(Universal),
    /// A pin in a sleeve.
    Cylindrical(Cylindrical),
    /// A slider in a straight guide.
    Prismatic(Prismatic),
    /// A plate on a plane.
    Planar(Planar),
    /// A point on a straight line.
    PointOnLine(PointOnLine),
    /// A massless rod with balls at its ends.
    Distance(Distance),
    /// A bead on a beam.
    Slide(Slide),
    /// An elastic mount.
    Bushing(Bushing),
    /// A spring and a damper between two points.
    Spring(PointSpring),
}

/// What a drive is tied to.
static GROUND: End = End::Ground;

fn one() -> f64 {
    1.0
}

impl Joint {
    /// A hinge on which nothing acts.
    pub fn revolute(name: &str, a: Place, b: End, axis: [f64; 3]) -> Self {
        Self::Revolute { name: name.into(), a, b, axis, drive: None, spring: None, friction: None }
    }

    /// Name in outputs and messages.
    pub fn name(&self) -> &str {
        match self {
            Self::Clamp { name, .. }
            | Self::Revolute { name, .. }
            | Self::Spherical { name, .. }
            | Self::Drive { name, .. }
            | Self::Universal(Universal { name, .. })
            | Self::Cylindrical(Cylindrical { name, .. })
            | Self::Prismatic(Prismatic { name, .. })
            | Self::Planar(Planar { name, .. })
            | Self::PointOnLine(PointOnLine { name, .. })
            | Self::Distance(Distance { name, .. })
            | Self::Slide(Slide { name, .. })
            | Self::Bushing(Bushing { name, .. })
            | Self::Spring(PointSpring { name, .. }) => name,
        }
    }

    /// The two ends.
    pub fn ends(&self) -> (&Place, &End) {
        match self {
            Self::Drive { a, .. } => (a, &GROUND),
            Self::Clamp { a, b, .. }
            | Self::Revolute { a, b, .. }
            | Self::Spherical { a, b, .. }
            | Self::Universal(Universal { a, b, .. })
            | Self::Cylindrical(Cylindrical { a, b, .. })
            | Self::Prismatic(Prismatic { a, b, .. })
            | Self::Planar(Planar { a, b, .. })
            | Self::PointOnLine(PointOnLine { a, b, .. })
            | Self::Distance(Distance { a, b, .. })
            | Self::Slide(Slide { a, b, .. })
            | Self::Bushing(Bushing { a, b, .. })
            | Self::Spring(PointSpring { a, b, .. }) => (a, b),
        }
    }

    /// Its functions of time, and the tables that have them as `time`.
    pub fn times(&self) -> Vec<(&'static str, &TimeFunction)> {
        match self {
            Self::Drive { time, .. } | Self::Distance(Distance { time, .. }) => vec![("", time)],
            Self::Cylindrical(Cylindrical { drive, feed, .. }) => {
                let drive = drive.iter().map(|drive| (".drive", &drive.time));
                drive.chain(feed.iter().map(|feed| (".feed", &feed.time))).collect()
            }
            Self::Revolute { drive, .. } => drive.iter().map(|drive| (".drive", &drive.time)).collect(),
            Self::Prismatic(Prismatic { drive, .. }) | Self::Slide(Slide { drive, .. }) => {
                drive.iter().map(|drive| (".drive", &drive.time)).collect()
            }
            _ => Vec::new(),
        }
    }

    /// The same to be changed.
    pub(crate) fn times_mut(&mut self) -> Vec<&mut TimeFunction> {
        match self {
            Self::Drive { time, .. } | Self::Distance(Distance { time, .. }) => vec![time],
            Self::Cylindrical(Cylindrical { drive, feed, .. }) => {
                let drive = drive.iter_mut().map(|drive| &mut drive.time);
                drive.chain(feed.iter_mut().map(|feed| &mut feed.time)).collect()
            }
            Self::Revolute { drive, .. } => drive.iter_mut().map(|drive| &mut drive.time).collect(),
            Self::Prismatic(Prismatic { drive, .. }) | Self::Slide(Slide { drive, .. }) => {
                drive.iter_mut().map(|drive| &mut drive.time).collect()
            }
            _ => Vec::new(),
        }
    }

    /// What acts along its angle.
    pub(crate) fn turning(&self) -> Acting<'_> {
        match self {
            Self::Revolute { drive, spring, friction, .. } => Acting::turning(drive, spring, friction),
            Self::Cylindrical(Cylindrical { drive, spring, .. }) => Acting::turning(drive, spring, &None),
            _ => Acting::default(),
        }
    }

    /// What acts along its displacement.
    pub(crate) fn moving(&self) -> Acting<'_> {
        match self {
            Self::Cylindrical(Cylindrical { feed, .. }) => Acting::moving(feed, &None, &None),
            Self::Prismatic(Prismatic { drive, spring, friction, .. })
            | Self::Slide(Slide { drive, spring, friction, .. }) => Acting::moving(drive, spring, friction),
            _ => Acting::default(),
        }
    }

    /// Whether it leads its place away.
    pub(crate) fn moves_place(&self) -> bool {
        matches!(self, Self::Drive { displacement, .. } if *displacement != [0.0; 3])
    }

    /// Whether a gap between its ends can be closed before the analysis begins.
    pub(crate) const fn closes(&self) -> bool {
        matches!(self, Self::Clamp { .. } | Self::Revolute { .. } | Self::Spherical { .. })
    }

    /// Whether its ends are meant to be apart.
    pub(crate) const fn spans(&self) -> bool {
        matches!(self, Self::Distance(_) | Self::Spring(_))
    }
}

/// Which gradients a clamp ties besides the position.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Clamped {
    /// r_x, r_y and r_z: all twelve coordinates of the node, as Kim et al. (2017) do. Stretch and shear of the axis
    /// are then zero at the clamp, which stiffens coarse meshes: 8/9 of the exact elongation for one element.
    All,
    /// r_y and r_z only: the section is fixed and the axis is free to stretch, exact in tension. Of a cable, the direction
    /// of the tangent.
    Section,
}
