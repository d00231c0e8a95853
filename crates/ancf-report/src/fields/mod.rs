//! Scalars along the bodies: section forces, resultants of shells, stress, strain, speed and displacement.

mod scalar_field;
mod section_stress;
mod surface_fields;

pub use scalar_field::{ScalarField, ScalarFields};
pub(crate) use section_stress::SectionStress;
