//! Scalars along the bodies: section forces, stress, strain, speed and displacement.

mod scalar_field;
mod section_stress;

pub use scalar_field::{ScalarField, ScalarFields};
pub(crate) use section_stress::SectionStress;
