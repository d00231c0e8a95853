//! Shells: thin ones of bicubic Hermite elements with Kirchhoff-Love strains, and shear-deformable ones of elements with three or four nodes.

mod element_surface;
mod laminates;
mod mesh;
mod pressure;
mod prestrain;
mod relative_thickness;
mod shear;
mod stress;
mod surface_stress;
mod thin;

pub use element_surface::ElementSurface;
pub use laminates::{
    Laminate, LocalSection, MembraneEnergy, MembraneLaw, MembraneState, PlaceFormula, Ply, PlyElasticity,
    SectionField, ShellSection, SurfaceMaterial, ThickSection,
};
pub use mesh::{ShellEdge, ShellMesh};
pub use pressure::{ElementPatch, EnclosedVolume, GasPressure, PatchMeasures, SurfacePatch};
pub use prestrain::SurfacePrestrain;
pub use shear::{
    Face, MeshTopology, NearestPoint, ShearMedium, ShearShellMesh, ShearStressField, SurfacePlace,
    TopologyDefect, directors, stress_axis,
};
pub(crate) use shear::{NODES, Shape, along_offset_edge};
pub use stress::StressField;
pub use surface_stress::{LAYERS, SurfaceStress};
pub use thin::{Shell48, ShellMedium, ShellProfile, VECTORS};
