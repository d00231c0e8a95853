//! Display geometry of rigid bodies: boxes, cylinders, balls and triangle meshes of files.
//!
//! ```text
//! model, mesh files -> surfaces of the bodies -> scene, ParaView, Python
//!                                            \-> folder `display` of a results folder
//! ```
//!
//! The motion does not depend on it.

mod body_surfaces;
mod files;
mod mesh;
mod shapes;

pub use body_surfaces::BodySurfaces;
pub use mesh::{ShadedTriangles, Triangles};
