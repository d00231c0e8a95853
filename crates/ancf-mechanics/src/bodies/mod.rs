//! Bodies: meshes of elements and rigid bodies, with their coordinates, terms and attachments.

mod body;
mod mesh;
mod resultants;

pub use body::Body;
pub(crate) use mesh::Elements;
pub use mesh::{BeamMesh, Blueprint, NodalVector};
pub use resultants::across;
