//! Bodies: meshes of elements and rigid bodies, with their coordinates, terms and attachments.

mod body_terms;
mod distributed;
mod element_axes;
mod mesh;
mod resultants;

pub use body_terms::Body;
pub use distributed::Piece;
pub use mesh::{BeamMesh, Blueprint};
pub use resultants::across;
