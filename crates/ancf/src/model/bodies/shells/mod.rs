//! Thin and shear-deformable shells, their layers and meshes.

mod element_mesh;
mod element_nodes;
mod fields;
mod layer;
mod layup;
mod membrane;
mod mesh_group;
mod shear_shell;
mod shell;
mod spline_surface;
mod surface;
mod sweep;

pub use element_mesh::ElementMesh;
pub use element_nodes::ElementNodes;
pub use fields::{AngleField, AxisField, FibreAngle, FibreAxis, ShellThickness, ThicknessField};
pub(crate) use fields::{FieldDefect, FieldShell};
pub use layer::Layer;
pub use layup::Layup;
pub use membrane::{Membrane, MembraneKind};
pub use mesh_group::MeshGroup;
pub use shear_shell::ShearShell;
pub use shell::Shell;
pub use surface::ShellSurface;
pub(crate) use surface::SurfaceGeometry;
