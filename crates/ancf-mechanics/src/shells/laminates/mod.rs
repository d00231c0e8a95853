//! Stiffness of shells per area, of one material or of plies.

mod laminate;
mod local_section;
mod membrane_law;
mod membrane_points;
mod place_formula;
mod prestrained_law;
mod prestrained_points;
mod section;
mod thick_section;

pub use laminate::{Laminate, Ply, PlyElasticity};
pub use local_section::{LocalSection, SectionField};
pub use membrane_law::{MembraneEnergy, MembraneLaw, MembraneState};
pub(crate) use membrane_points::MembranePoints;
pub use place_formula::PlaceFormula;
pub use section::{ShellSection, SurfaceMaterial};
pub(crate) use section::{strain_components, strain_tensor, strain_transform, to_orthonormal};
pub use thick_section::ThickSection;
