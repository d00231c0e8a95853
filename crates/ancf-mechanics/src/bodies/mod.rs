//! Bodies: meshes of elements and rigid bodies, with their coordinates, terms and attachments.

mod axial_motion;
mod body_terms;
mod distributed;
mod element_axes;
mod element_forces;
mod mesh;
mod mesh_element;
mod prestrained;
mod resultants;
mod rod_gaps;
mod section_frames;
mod strains;
mod surface_field;

pub use body_terms::BodyTerms;
pub use distributed::ElementSpan;
pub use mesh::{BeamMesh, MeshParameters};
pub use rod_gaps::RodGap;
pub use section_frames::{CarriedFrame, normals_to};
pub use strains::SectionStrain;
pub use surface_field::SurfaceField;
