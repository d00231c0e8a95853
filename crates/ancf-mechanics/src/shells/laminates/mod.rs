//! Stiffness of shells per area, of one material or of plies.

mod laminate;
mod membrane_law;
mod membrane_points;
mod section;
mod thick_section;

pub use laminate::{Laminate, Ply, PlyElasticity};
pub use membrane_law::{MembraneEnergy, MembraneLaw, MembraneState};
pub(crate) use membrane_points::MembranePoints;
pub use section::{ShellSection, SurfaceMaterial};
pub(crate) use section::{strain_transform, to_orthonormal};
pub use thick_section::ThickSection;
