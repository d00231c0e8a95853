//! Loads on the surface and on the edges of shells.

mod edge_force;
mod edge_moment;
mod gas;
mod surface_fluid;
mod surface_force;
mod surface_pressure;
mod surface_prestrain;

pub use edge_force::EdgeForce;
pub use edge_moment::EdgeMoment;
pub use gas::{Gas, GasSurface};
pub use surface_fluid::SurfaceFluid;
pub use surface_force::SurfaceForce;
pub use surface_pressure::SurfacePressure;
pub use surface_prestrain::SurfacePrestrain;
