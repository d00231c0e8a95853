//! Prescribed strains of shells: heating, swelling, pretension, natural curvature.

mod element;
mod law_element;
mod law_term;
mod list;
mod prescription;
mod reference_point;
mod source;
mod term;

pub(crate) use element::StrainedElement;
pub(crate) use law_element::LawElement;
pub(crate) use list::{ElementPrestrain, SurfacePrestrains};
pub(crate) use reference_point::ReferencePoint;
pub use source::SurfacePrestrain;
pub(crate) use source::{Factors, StrainField, SurfaceLaw};
