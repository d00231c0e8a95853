//! Shear-deformable shells: elements of three or four nodes with a position and a director at each, on any mesh.

mod any_element;
mod directors;
mod element;
mod faces;
mod law_element;
mod membrane;
mod mesh;
mod profile;
mod strains;
mod stress;
mod surface;

pub use directors::{directors, stress_axis};
pub use faces::{Face, MeshTopology, TopologyDefect};
pub(crate) use faces::{NODES, Shape};
pub use mesh::{ShearShellMesh, SurfacePlace};
pub use profile::ShearMedium;
pub use stress::ShearStressField;
pub use surface::NearestPoint;
pub(crate) use surface::along_offset_edge;
