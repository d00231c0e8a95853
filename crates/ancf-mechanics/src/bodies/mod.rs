//! Bodies: meshes of elements and rigid bodies, with their coordinates, terms and attachments.

mod body_terms;
mod distributed;
mod element_axes;
mod mesh;
mod mesh_element;
mod resultants;

pub use body_terms::BodyTerms;
pub use distributed::ElementSpan;
pub use mesh::{BeamMesh, MeshParameters};
pub use resultants::normals_to;
