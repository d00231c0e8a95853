//! Prescribed strains of shells: heating, swelling, pretension, natural curvature.

mod element;
mod list;
mod shear;
mod source;
mod term;
mod thin;

pub(crate) use element::StrainedElement;
pub(crate) use list::{ElementPrestrain, SurfacePrestrains};
pub(crate) use source::SurfaceLaw;
pub use source::SurfacePrestrain;
pub(crate) use term::Factors;
