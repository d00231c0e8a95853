//! Thin shells: bicubic Hermite elements with Kirchhoff-Love strains.

mod element;
mod hermite;
mod mesh;
mod pressure;
mod profile;
mod rounding;
mod section;
mod stiffness;
mod stress;
mod surface_state;
mod surface_stress;

pub use element::Shell48;
pub use hermite::VECTORS;
pub use mesh::{ShellEdge, ShellMesh};
pub use pressure::SurfacePressure;
pub use profile::{ShellMedium, ShellProfile};
pub use section::ShellSection;
pub use stress::StressField;
pub use surface_stress::{LAYERS, SurfaceStress};
