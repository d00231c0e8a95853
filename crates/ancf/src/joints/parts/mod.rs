//! Parts of joints: ends, actions along joint coordinates, the builder of constraint equations.

mod acting;
mod builder;
mod clamped;
mod clamping;
mod coupling;
mod custom;
mod end;
mod equations;
mod freedom;
mod kind;
pub(crate) mod measures;
mod term;

pub use acting::{
    Acting, AngularDrive, AngularFriction, AngularSpring, Led, LinearDrive, LinearFriction, LinearSpring,
};
pub use builder::JointBuilder;
pub(crate) use builder::{JointEnds, Numbering};
pub use clamped::Clamped;
pub use coupling::{Coupled, Coupling, Freed};
pub use custom::CustomJoint;
pub use end::{End, Ground};
pub use equations::Closed;
pub(crate) use equations::{Gap, JointEquations};
pub use freedom::Freedom;
pub use kind::{JointContext, JointKind, JointObject, Symbol};
pub use term::JointTerm;
