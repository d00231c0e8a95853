//! Parts of joints: ends, actions along joint coordinates, the builder of constraint equations.

mod acting;
mod actions;
mod builder;
mod clamping;
mod coupling;
mod end;
mod equations;
mod friction;
mod kind;
pub(crate) mod measures;
mod recorded_coordinate;
mod term;

pub use actions::{
    AngularDrive, AngularSpring, AngularStops, JointActions, LinearDrive, LinearSpring, LinearStops,
    PrescribedMotion,
};
pub use builder::JointBuilder;
pub use coupling::{Coupled, Coupling, JointCoordinate};
pub use end::{ClampedGradients, End, Ground};
pub use equations::GapClosure;
pub(crate) use equations::{
    EquationOwner, Gap, JointBody, JointEnds, JointEquations, JointStateLaw, LinearRows, Numbering, Part,
};
pub use friction::{AngularFriction, JointFriction, LinearFriction};
pub use kind::{JointContext, JointKind, JointObject, JointSymbol};
pub use recorded_coordinate::RecordedCoordinate;
pub(crate) use recorded_coordinate::Source;
pub use term::JointTerm;
