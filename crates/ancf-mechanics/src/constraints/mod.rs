//! Constraint equations of joints, with multipliers.

mod bilinear_measure;
mod bilinear_row;
mod coincidence;
mod constraint_group;
mod hinge_angle;
mod linear_constraint;
mod measure_constraint;
mod measure_target;
mod rotation_drive;
mod section_drive;
mod slide_constraint;
mod twist_angle;

pub(crate) use bilinear_measure::add_outer;
pub use bilinear_measure::{BilinearMeasure, MeasureFactor};
pub(crate) use bilinear_row::BilinearRow;
pub use coincidence::{CoincidenceConstraint, ConstantAngle, Wrench};
pub use constraint_group::{ConstraintGroup, GroupedConstraint};
pub use hinge_angle::HingeAngle;
pub use linear_constraint::{ConstrainedVector, LinearConstraint};
pub use measure_constraint::MeasureConstraint;
pub use measure_target::MeasureTarget;
pub use rotation_drive::RotationDrive;
pub use section_drive::SectionDrive;
pub use slide_constraint::SlideConstraint;
pub use twist_angle::TwistAngle;
