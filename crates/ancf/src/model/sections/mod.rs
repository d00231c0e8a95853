//! Cross-sections and materials of a model.

mod cubature;
mod material;
mod rigidity;
mod section;

pub use material::{Damping, Material, MaterialLaw};
pub use section::Section;
