//! Parts of joints: ends, actions along joint coordinates, the builder of constraint equations.

mod actuation;
mod builder;
mod clamped;
mod clamping;
mod coordinate;
mod coupling;
mod custom;
mod end;
mod equations;
mod kind;
pub(crate) mod measures;
mod term;

pub use actuation::{
    AngularDrive, AngularFriction, AngularSpring, JointActuation, LinearDrive, LinearFriction, LinearSpring,
    PrescribedMotion,
};
pub use builder::JointBuilder;
pub(crate) use builder::{JointEnds, Numbering};
pub use clamped::Clamped;
pub use coordinate::JointCoordinate;
pub use coupling::{Coupled, Coupling, Freed};
pub use custom::CustomJoint;
pub use end::{End, Ground};
pub use equations::GapClosure;
pub(crate) use equations::{Gap, JointEquations};
pub use kind::{JointContext, JointKind, JointObject, Symbol};
pub use term::JointTerm;
