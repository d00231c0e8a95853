//! Prescribed strains of shells: heating, swelling, pretension, natural curvature.

mod element;
mod list;
mod source;
mod term;

pub(crate) use element::{StrainField, StrainedElement};
pub(crate) use list::{ElementPrestrain, SurfacePrestrains};
pub(crate) use source::SurfaceLaw;
pub use source::SurfacePrestrain;
pub(crate) use term::Factors;
