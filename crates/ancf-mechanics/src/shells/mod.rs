//! Shells: thin ones of bicubic Hermite elements with Kirchhoff-Love strains, and shear-deformable ones of elements with three or four nodes.

mod element;
mod element_surface;
mod hermite;
mod laminates;
mod mesh;
mod nonlinear_membrane;
mod pressure;
mod prestrain;
mod profile;
mod rounding;
mod rows;
mod shear;
mod stiffness;
mod stress;
mod surface_state;
mod surface_stress;

pub use element::Shell48;
pub use element_surface::ElementSurface;
pub use hermite::VECTORS;
pub use laminates::{
    Laminate, LocalSection, MembraneEnergy, MembraneLaw, MembraneState, PlaceFormula, Ply, PlyElasticity,
    SectionField, ShellSection, SurfaceMaterial, ThickSection,
};
pub use mesh::{ShellEdge, ShellMesh};
pub use pressure::{ElementPatch, EnclosedVolume, GasPressure, PatchMeasures, SurfacePatch};
pub use prestrain::SurfacePrestrain;
pub use profile::{ShellMedium, ShellProfile};
pub use shear::{
    Face, MeshTopology, NearestPoint, ShearMedium, ShearShellMesh, ShearStressField, ShellPlace,
    SurfacePlace, TopologyDefect, directors, stress_axis,
};
pub(crate) use shear::{NODES, Shape};
pub use stress::StressField;
pub use surface_stress::{LAYERS, SurfaceStress};
