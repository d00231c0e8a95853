//! Constraint equations of prescribed rotations of bodies and sections.

mod rotation_drive;
mod section_drive;

pub use rotation_drive::RotationDrive;
pub use section_drive::SectionDrive;
