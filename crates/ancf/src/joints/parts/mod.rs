//! Parts of joints: ends, actions along joint coordinates, the builder of constraint equations.

mod actions;
mod builder;
mod clamped_gradients;
mod clamping;
mod coupling;
mod custom;
mod end;
mod equations;
mod kind;
pub(crate) mod measures;
mod recorded_coordinate;
mod term;

pub use actions::{
    AngularDrive, AngularFriction, AngularSpring, AngularStops, JointActions, LinearDrive, LinearFriction,
    LinearSpring, LinearStops, PrescribedMotion,
};
pub use builder::JointBuilder;

pub use clamped_gradients::ClampedGradients;
pub use coupling::{Coupled, Coupling, JointCoordinate};
pub use custom::CustomJoint;
pub use end::{End, Ground};
pub use equations::GapClosure;
pub(crate) use equations::{Gap, JointEnds, JointEquations, LinearRows, Numbering};
pub use kind::{JointContext, JointKind, JointObject, JointSymbol};
pub use recorded_coordinate::RecordedCoordinate;
pub use term::JointTerm;
