//! Joints and couplings of a model.

mod acting;
mod coupling;
mod joint;
mod joint_kinds;

pub(crate) use acting::Acting;
pub use acting::{AngularDrive, AngularFriction, AngularSpring, LinearDrive, LinearFriction, LinearSpring};
pub use coupling::{Coupled, Coupling, Freed};
pub use joint::{Clamped, End, Ground, Joint};
pub use joint_kinds::{
    Bushing, Cylindrical, Distance, Planar, PointOnLine, PointSpring, Prismatic, Slide, Universal,
};
