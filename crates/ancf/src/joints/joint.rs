use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::clamp::Clamp;
use super::cylindrical::Cylindrical;
use super::distance::Distance;
use super::drive::DrivenClamp;
use super::planar::Planar;
use super::point_on_line::PointOnLine;
use super::prismatic::Prismatic;
use super::revolute::Revolute;
use super::slide::Slide;
use super::spherical::Spherical;
use super::universal::Universal;
use crate::joints::elastic::{Bushing, PointSpring};
use crate::joints::general::{CustomJoint, Generic, MatrixBushing, Sensor};
use crate::joints::parts::{ClampedGradients, End, JointKind};
use crate::joints::surface::{Bond, Seam, Support};
use crate::model::{Place, TimeFunction};
use crate::units::Scaled;

/// Declares the kinds of joints of model files: variant and data of each.
macro_rules! joint_kinds {
    ($($kind:ident($data:ident),)*) => {
        /// Joint between a body and the ground or another body.
        ///
        /// Reactions are the force and the moment that the joint exerts on its end `a`.
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
        #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
        #[expect(missing_docs, reason = "the data of each kind are documented")]
        pub enum Joint {
            $($kind($data),)*
            /// Joint of a kind that a program adds. Model files do not have such joints.
            #[serde(skip)]
            #[schemars(skip)]
            Custom(CustomJoint),
        }

        impl Joint {
            /// Joint as an implementation of its kind.
            pub fn kind(&self) -> &dyn JointKind {
                match self {
                    $(Self::$kind(joint) => joint,)*
                    Self::Custom(joint) => joint.kind(),
                }
            }

            /// Joint as a mutable implementation of its kind.
            pub(crate) fn kind_mut(&mut self) -> &mut dyn JointKind {
                match self {
                    $(Self::$kind(joint) => joint,)*
                    Self::Custom(joint) => joint.kind_mut(),
                }
            }
        }

        $(impl From<$data> for Joint {
            fn from(joint: $data) -> Self {
                Self::$kind(joint)
            }
        })*
    };
}

joint_kinds! {
    Clamp(Clamp),
    Revolute(Revolute),
    Spherical(Spherical),
    Drive(DrivenClamp),
    Universal(Universal),
    Cylindrical(Cylindrical),
    Prismatic(Prismatic),
    Planar(Planar),
    PointOnLine(PointOnLine),
    Distance(Distance),
    Slide(Slide),
    Bushing(Bushing),
    Spring(PointSpring),
    Generic(Generic),
    MatrixBushing(MatrixBushing),
    Support(Support),
    Seam(Seam),
    Bond(Bond),
    Sensor(Sensor),
}

impl Joint {
    /// Clamp with the default gradients of its bodies.
    pub fn clamp(name: &str, a: Place, b: End) -> Self {
        Self::clamped(name, a, b, None)
    }

    /// Clamp of given gradients.
    pub fn clamped(name: &str, a: Place, b: End, fix: Option<ClampedGradients>) -> Self {
        Self::Clamp(Clamp { name: name.into(), a, b, fix })
    }

    /// Hinge without drive, spring and friction.
    pub fn revolute(name: &str, a: Place, b: End, axis: [f64; 3]) -> Self {
        Self::Revolute(Revolute {
            name: name.into(),
            a,
            b,
            axis,
            drive: None,
            spring: None,
            friction: None,
            moment: None,
            stops: None,
        })
    }

    /// Ball joint.
    pub fn spherical(name: &str, a: Place, b: End) -> Self {
        Self::Spherical(Spherical { name: name.into(), a, b, friction: None })
    }

    /// Name in outputs and messages.
    pub fn name(&self) -> &str {
        self.kind().name()
    }

    /// First and second end.
    pub fn ends(&self) -> (&Place, &End) {
        self.kind().ends()
    }

    /// Functions of time, each with the suffix of its table.
    pub fn times(&self) -> Vec<(&'static str, &TimeFunction)> {
        self.kind().times()
    }
}
