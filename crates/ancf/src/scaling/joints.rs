//! Conversion of joints to other units.

use crate::model::Joint;
use crate::units::{Dimension, Scaled, Scales, vector};

impl Scaled for Joint {
    fn scaled(self, scales: &Scales) -> Self {
        // The inherent function.
        Self::scaled(self, scales)
    }
}

impl Joint {
    pub(crate) fn scaled(self, s: &Scales) -> Self {
        match self {
            Self::Clamp { name, a, b, fix } => Self::Clamp { name, a: a.scaled(s), b: b.scaled(s), fix },
            Self::Revolute { name, a, b, axis, drive, spring, friction } => Self::Revolute {
                name,
                a: a.scaled(s),
                b: b.scaled(s),
                axis,
                drive: drive.map(|drive| drive.scaled(s)),
                spring: spring.map(|spring| spring.scaled(s)),
                friction: friction.map(|friction| friction.scaled(s)),
            },
            Self::Spherical { name, a, b } => Self::Spherical { name, a: a.scaled(s), b: b.scaled(s) },
            Self::Drive { name, a, axis, angle, displacement, time, fix } => {
                let displacement = vector(displacement, Dimension::LENGTH, s);
                Self::Drive { name, a: a.scaled(s), axis, angle, displacement, time: time.scaled(s), fix }
            }
            Self::Universal(joint) => Self::Universal(joint.scaled(s)),
            Self::Cylindrical(joint) => Self::Cylindrical(joint.scaled(s)),
            Self::Prismatic(joint) => Self::Prismatic(joint.scaled(s)),
            Self::Planar(joint) => Self::Planar(joint.scaled(s)),
            Self::PointOnLine(joint) => Self::PointOnLine(joint.scaled(s)),
            Self::Distance(joint) => Self::Distance(joint.scaled(s)),
            Self::Slide(joint) => Self::Slide(joint.scaled(s)),
            Self::Bushing(joint) => Self::Bushing(joint.scaled(s)),
            Self::Spring(joint) => Self::Spring(joint.scaled(s)),
        }
    }
}
