//! Forces along one coordinate by general laws.

mod coordinate_force;
mod signal;
mod state_force;

pub use coordinate_force::CoordinateForce;
pub use signal::{Signal, SignalSource};
pub use state_force::StateForce;
