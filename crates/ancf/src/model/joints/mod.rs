//! Joints and couplings of a model.

mod acting;
mod coupling;
mod end;
mod joint;
mod joint_kinds;

pub(crate) use acting::Acting;
pub use acting::{AngularDrive, AngularFriction, AngularSpring, LinearDrive, LinearFriction, LinearSpring};
pub use coupling::{Coupled, Coupling, Freed};
pub use end::{End, Ground};
pub use joint::{Clamped, Joint};
pub use joint_kinds::{
    Bushing, Cylindrical, Distance, Planar, PointOnLine, PointSpring, Prismatic, Slide, Universal,
};
