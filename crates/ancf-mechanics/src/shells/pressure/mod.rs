//! Pressure on the surfaces of shells: given pressures, enclosed volumes and the gas in them.

mod element_patch;
mod enclosed_volume;
mod gas_pressure;
mod surface_patch;
mod surface_pressure;

pub use element_patch::{ElementPatch, PatchMeasures};
pub use enclosed_volume::EnclosedVolume;
pub use gas_pressure::GasPressure;
pub use surface_patch::SurfacePatch;
