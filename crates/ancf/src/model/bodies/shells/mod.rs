//! Thin and shear-deformable shells, their layers and meshes.

mod layer;
mod layup;
mod mesh_group;
mod quad_mesh;
mod shear_shell;
mod shell;

pub use layer::Layer;
pub use layup::Layup;
pub use mesh_group::MeshGroup;
pub use quad_mesh::QuadMesh;
pub use shear_shell::ShearShell;
pub use shell::{Shell, ShellSurface};
