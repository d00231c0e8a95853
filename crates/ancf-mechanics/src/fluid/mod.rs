//! Hydrodynamic loads: drag, added mass, buoyancy.

mod flow;
mod immersed;
mod morison;

pub use flow::{Fluid, Hull};
pub use morison::Morison;
