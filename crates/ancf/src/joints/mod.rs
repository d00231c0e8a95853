//! Joints: one file per kind, and one line per kind in `joint.rs`.
//!
//! A kind of joint implements [`JointKind`]: data and units, required capabilities, checks, constraint equations, symbol in figures.

mod clamp;
mod cylindrical;
mod distance;
mod drive;
mod elastic;
mod general;
mod joint;
mod parts;
mod planar;
mod point_on_line;
mod prismatic;
mod revolute;
mod slide;
mod spherical;
mod surface;
mod universal;

pub use crate::model::Capability;
pub use clamp::Clamp;
pub use cylindrical::Cylindrical;
pub use distance::Distance;
pub use drive::DrivenClamp;
pub use elastic::{Bushing, PointSpring};
pub use general::{CustomJoint, DirectionMotion, Generic, MatrixBushing, Measure, Sensor};
pub use joint::Joint;
pub use parts::{
    AngularDrive, AngularFriction, AngularSpring, AngularStops, ClampedGradients, Coupled, Coupling, End,
    GapClosure, Ground, JointActions, JointBuilder, JointContext, JointCoordinate, JointFriction, JointKind,
    JointObject, JointSymbol, JointTerm, LinearDrive, LinearFriction, LinearSpring, LinearStops,
    PrescribedMotion, RecordedCoordinate,
};
pub(crate) use parts::{
    EquationOwner, Gap, JointBody, JointEnds, JointEquations, JointStateLaw, LinearRows, Numbering, Part,
    Source,
};
pub use planar::Planar;
pub use point_on_line::PointOnLine;
pub use prismatic::Prismatic;
pub use revolute::Revolute;
pub use slide::Slide;
pub use spherical::Spherical;
pub use surface::{Bond, Seam, SeamCondition, Support, SupportCondition, SupportedAxis};
pub use universal::Universal;
