//! Bodies: meshes of elements and rigid bodies, with their coordinates, terms and attachments.

mod body_terms;
mod distributed;
mod element_axes;
mod mesh;
mod mesh_element;
mod resultants;
mod section_frames;
mod strains;

pub use body_terms::BodyTerms;
pub use distributed::ElementSpan;
pub use mesh::{BeamMesh, MeshParameters};
pub use section_frames::{CarriedFrame, normals_to};
