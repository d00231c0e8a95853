//! Bodies: meshes of elements and rigid bodies, with their coordinates, terms and attachments.

mod axial_motion;
mod body_terms;
mod distributed;
mod element_axes;
mod mesh;
mod mesh_element;
mod places;
mod prestrained;
mod section_forces;
mod section_frames;
mod shell_place;
mod strains;
mod surface_field;

pub use body_terms::BodyTerms;
pub use distributed::ElementSpan;
pub use mesh::{BeamMesh, MeshParameters};
pub use section_forces::RodGap;
pub use section_frames::{CarriedFrame, normals_to};
pub use shell_place::ShellPlace;
pub use strains::SectionStrain;
pub use surface_field::SurfaceField;
