//! Faces of meshes of quadrilaterals and triangles, their topology and its defects.

mod defect;
mod face;
mod mesh_topology;
mod near_nodes;

pub use defect::TopologyDefect;
pub use face::Face;
pub(crate) use face::{NODES, Shape, ShapeValues};
pub use mesh_topology::MeshTopology;
