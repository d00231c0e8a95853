//! Thin shells: bicubic Hermite elements with Kirchhoff-Love strains.

mod element;
mod hermite;
mod laminates;
mod mesh;
mod pressure;
mod profile;
mod rounding;
mod rows;
mod stiffness;
mod stress;
mod surface_state;
mod surface_stress;

pub use element::Shell48;
pub use hermite::VECTORS;
pub use laminates::{Laminate, Ply, PlyElasticity, ShellSection, SurfaceMaterial};
pub use mesh::{ShellEdge, ShellMesh};
pub use pressure::SurfacePressure;
pub use profile::{ShellMedium, ShellProfile};
pub use stress::StressField;
pub use surface_stress::{LAYERS, SurfaceStress};
