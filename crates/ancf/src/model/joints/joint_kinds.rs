//! Joints that are stated by tables of their own.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::acting::{AngularDrive, AngularSpring, LinearDrive, LinearFriction, LinearSpring};
use super::end::End;
use crate::model::bodies::Place;
use crate::model::functions::TimeFunction;
use crate::units::{Dimension, Scaled, Scales, number};

/// Two shafts that meet: ties the position and keeps the angle between an axis of each, as the cross of a Cardan joint does.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Universal {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// The end that receives the reaction.
    pub a: Place,
    /// The other end; the ground by default.
    #[serde(default)]
    pub b: End,
    /// Direction of the arm of the cross that is fixed to `a`, in the undeformed state.
    pub axis_a: [f64; 3],
    /// Direction of the arm of the cross that is fixed to `b`, in the undeformed state, not along the other.
    pub axis_b: [f64; 3],
}

/// A pin in a sleeve: leaves rotation about an axis and displacement along it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cylindrical {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// The end that receives the reaction.
    pub a: Place,
    /// The other end, which carries the axis; the ground by default.
    #[serde(default)]
    pub b: End,
    /// Direction of the axis in the undeformed state, in the global frame; its length does not matter.
    pub axis: [f64; 3],
    /// Prescribes the angle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drive: Option<AngularDrive>,
    /// A torsion spring and a damper.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spring: Option<AngularSpring>,
    /// Prescribes the displacement.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub feed: Option<LinearDrive>,
}

/// A slider in a straight guide: leaves displacement along an axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Prismatic {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// The end that receives the reaction.
    pub a: Place,
    /// The other end, which carries the axis; the ground by default.
    #[serde(default)]
    pub b: End,
    /// Direction of the axis in the undeformed state, in the global frame; its length does not matter.
    pub axis: [f64; 3],
    /// Prescribes the displacement.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drive: Option<LinearDrive>,
    /// A spring and a damper.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spring: Option<LinearSpring>,
    /// Dry friction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<LinearFriction>,
}

/// A plate on a plane: leaves displacements in a plane and rotation about its normal.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Planar {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// The end that receives the reaction.
    pub a: Place,
    /// The other end, which carries the plane; the ground by default.
    #[serde(default)]
    pub b: End,
    /// Normal of the plane in the undeformed state, in the global frame; its length does not matter.
    pub normal: [f64; 3],
}

/// A point on a straight line: leaves displacement along it and all rotations.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointOnLine {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// The end that receives the reaction.
    pub a: Place,
    /// The other end, which carries the line; the ground by default.
    #[serde(default)]
    pub b: End,
    /// Direction of the line in the undeformed state, in the global frame; its length does not matter.
    pub axis: [f64; 3],
}

/// A massless rod with balls at its ends: keeps the distance of two points, or leads it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Distance {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// The end that receives the reaction.
    pub a: Place,
    /// The other end: a place or a point of the ground, elsewhere than `a`.
    pub b: End,
    /// By how much the distance grows, times the function of time, length; 0 by default.
    #[serde(default)]
    pub change: f64,
    /// Function of time; 1 by default. Statics ignores it and changes the distance with the load.
    #[serde(default)]
    pub time: TimeFunction,
}

/// A bead on a beam: a point slides along the axis of a beam, bent as it is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Slide {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// The point that slides, and receives the reaction.
    pub a: Place,
    /// The place of a beam of two-node elements or of a cable where it is at the start.
    pub b: End,
    /// Prescribes the displacement along the beam.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drive: Option<LinearDrive>,
    /// A spring and a damper along the beam.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spring: Option<LinearSpring>,
    /// Dry friction along the beam, of a given force.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<LinearFriction>,
}

/// An elastic mount: springs and dampers between two places that coincide, three along and three about the axes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bushing {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// The end that receives the reaction.
    pub a: Place,
    /// The other end, which carries the axes, at first the global ones; the ground by default.
    #[serde(default)]
    pub b: End,
    /// Stiffnesses along x, y, z, force/length, and about x, y, z, force length.
    pub stiffness: [f64; 6],
    /// Dampings along x, y, z, force time/length, and about x, y, z, force length time; none by default.
    #[serde(default)]
    pub damping: [f64; 6],
}

/// A spring and a damper between two points.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointSpring {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// The end that receives the reaction.
    pub a: Place,
    /// The other end: a place or a point of the ground, elsewhere than `a`.
    pub b: End,
    /// Stiffness, force/length.
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub stiffness: f64,
    /// Damping, force time/length.
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub damping: f64,
    /// Length at which it is free of force; the distance in the undeformed state by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0))]
    pub length: Option<f64>,
    /// Whether it only draws, as a rope does.
    #[serde(default)]
    pub tension_only: bool,
}

impl Universal {
    pub(crate) fn scaled(self, s: &Scales) -> Self {
        Self { a: self.a.scaled(s), b: self.b.scaled(s), ..self }
    }
}

impl Cylindrical {
    pub(crate) fn scaled(self, s: &Scales) -> Self {
        let Self { name, a, b, axis, drive, spring, feed } = self;
        let (drive, feed) = (drive.map(|drive| drive.scaled(s)), feed.map(|feed| feed.scaled(s)));
        let spring = spring.map(|spring| spring.scaled(s));
        Self { name, a: a.scaled(s), b: b.scaled(s), axis, drive, spring, feed }
    }
}

impl Prismatic {
    pub(crate) fn scaled(self, s: &Scales) -> Self {
        let Self { name, a, b, axis, drive, spring, friction } = self;
        Self {
            name,
            a: a.scaled(s),
            b: b.scaled(s),
            axis,
            drive: drive.map(|drive| drive.scaled(s)),
            spring: spring.map(|spring| spring.scaled(s)),
            friction: friction.map(|friction| friction.scaled(s)),
        }
    }
}

impl Planar {
    pub(crate) fn scaled(self, s: &Scales) -> Self {
        Self { a: self.a.scaled(s), b: self.b.scaled(s), ..self }
    }
}

impl PointOnLine {
    pub(crate) fn scaled(self, s: &Scales) -> Self {
        Self { a: self.a.scaled(s), b: self.b.scaled(s), ..self }
    }
}

impl Distance {
    pub(crate) fn scaled(self, s: &Scales) -> Self {
        let Self { name, a, b, change, time } = self;
        let change = number(change, Dimension::LENGTH, s);
        Self { name, a: a.scaled(s), b: b.scaled(s), change, time: time.scaled(s) }
    }
}

impl Slide {
    pub(crate) fn scaled(self, s: &Scales) -> Self {
        let Self { name, a, b, drive, spring, friction } = self;
        Self {
            name,
            a: a.scaled(s),
            b: b.scaled(s),
            drive: drive.map(|drive| drive.scaled(s)),
            spring: spring.map(|spring| spring.scaled(s)),
            friction: friction.map(|friction| friction.scaled(s)),
        }
    }
}

impl Bushing {
    pub(crate) fn scaled(self, s: &Scales) -> Self {
        let Self { name, a, b, stiffness, damping } = self;
        let six = |x: [f64; 6], time: i32| {
            let of = |k: usize| Dimension::new(if k < 3 { -1 } else { 1 }, time, 1);
            std::array::from_fn(|k| number(x[k], of(k), s))
        };
        Self { name, a: a.scaled(s), b: b.scaled(s), stiffness: six(stiffness, 0), damping: six(damping, 1) }
    }
}

impl PointSpring {
    pub(crate) fn scaled(self, s: &Scales) -> Self {
        let Self { name, a, b, stiffness, damping, length, tension_only } = self;
        Self {
            name,
            a: a.scaled(s),
            b: b.scaled(s),
            stiffness: number(stiffness, Dimension::new(-1, 0, 1), s),
            damping: number(damping, Dimension::new(-1, 1, 1), s),
            length: length.map(|x| number(x, Dimension::LENGTH, s)),
            tension_only,
        }
    }
}
