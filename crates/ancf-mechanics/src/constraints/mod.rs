//! Constraint equations of joints, with multipliers.

mod bilinear_measure;
mod coincidence;
mod hinge_angle;
mod measure_constraint;
mod measure_target;
mod rotation_drive;
mod slide_constraint;

pub(crate) use bilinear_measure::add_outer;
pub use bilinear_measure::{Measure, Part};
pub use coincidence::{Coincide, Perpendicular, Wrench};
pub use hinge_angle::Angle;
pub use measure_constraint::Tie;
pub use measure_target::Target;
pub use rotation_drive::Drive;
pub use slide_constraint::Slide;
