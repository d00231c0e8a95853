//! Static equilibrium: load increments and arc-length continuation.

mod arc;
mod equilibrium;
mod load_stepper;
mod path;
mod settle;
mod waypoint;

pub use equilibrium::Equilibrium;
pub use load_stepper::{Increments, Statics};
pub use path::Path;
pub use settle::settle;
pub use waypoint::{ArcSteps, Left, Limit, PathPoint, Until};
