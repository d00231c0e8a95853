//! Cross-sections and materials of a model.
//!
//! One file per kind of section, and one line per kind in `section.rs`. A kind implements [`SectionShape`].

mod circle;
mod cubature;
mod custom;
mod ellipse;
mod general;
mod material;
mod outline;
mod rectangle;
mod section;
mod shape;
#[cfg(test)]
mod tests;
mod tube;

pub use circle::Circle;
pub use custom::{CustomSection, SectionObject};
pub use ellipse::Ellipse;
pub use general::GeneralSection;
pub use material::{Damping, Material, MaterialLaw, Orthotropic};
pub use outline::{OutlineCurve, SectionOutline};
pub use rectangle::Rectangle;
pub use section::Section;
pub use shape::SectionShape;
pub(crate) use shape::disk_area;
pub use tube::Tube;
