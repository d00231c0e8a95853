//! Hydrodynamic loads: drag, added mass and buoyancy.

mod flow_field;
mod hydrodynamic_loads;
mod morison;

pub use flow_field::{FlowField, HydroSection};
pub use morison::MorisonLoad;
