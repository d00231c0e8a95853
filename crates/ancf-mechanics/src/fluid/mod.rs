//! Hydrodynamic loads: drag, added mass and buoyancy.

mod flow;
mod immersed;
mod morison;

pub use flow::{Fluid, Hull};
pub use morison::Morison;
