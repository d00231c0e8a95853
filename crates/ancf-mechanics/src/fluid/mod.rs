//! Hydrodynamic loads: drag, added mass and buoyancy.

mod blocks;
mod flow_field;
mod hydrodynamic_loads;
mod morison;
mod surface_flow;

pub use flow_field::{FlowField, HydroSection, HydroSurface};
pub use morison::MorisonLoad;
pub use surface_flow::SurfaceFlowLoad;
