//! Forces along one coordinate by general laws.

mod coordinate_force;
mod state_force;

pub use coordinate_force::CoordinateForce;
pub use state_force::StateForce;
