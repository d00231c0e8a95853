//! Constraint equations of joints, with multipliers.

mod bilinear_measure;
mod bilinear_row;
mod coincidence;
mod constant_angle;
mod constraint_group;
mod drives;
mod hinge_angle;
mod linear_constraint;
mod measure_constraint;
mod measure_target;
mod slide_constraint;
mod twist_angle;
mod wrench;

pub(crate) use bilinear_measure::add_outer;
pub use bilinear_measure::{BilinearMeasure, MeasureFactor};
pub(crate) use bilinear_row::BilinearRow;
pub use coincidence::CoincidenceConstraint;
pub use constant_angle::ConstantAngle;
pub use constraint_group::{ConstraintGroup, GroupedConstraint};
pub use drives::{RotationDrive, SectionDrive};
pub use hinge_angle::HingeAngle;
pub use linear_constraint::{ConstrainedVector, LinearConstraint};
pub use measure_constraint::MeasureConstraint;
pub use measure_target::MeasureTarget;
pub use slide_constraint::SlideConstraint;
pub use twist_angle::TwistAngle;
pub use wrench::Wrench;
