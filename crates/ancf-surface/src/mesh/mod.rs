//! Triangle meshes and their normals.

mod shading;
mod triangles;

pub use shading::ShadedTriangles;
pub use triangles::Triangles;
