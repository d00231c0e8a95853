//! Prescribed strains of shells: heating, swelling, pretension, natural curvature.

mod element;
mod list;
mod source;
mod term;

pub(crate) use element::StrainedElement;
pub(crate) use list::{ElementPrestrain, SurfacePrestrains};
pub use source::SurfacePrestrain;
pub(crate) use source::{Factors, StrainField, SurfaceLaw};
