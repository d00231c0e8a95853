//! Static equilibrium: load increments and arc-length continuation.

mod arc_length;
mod arc_metric;
mod equilibrium;
mod load_stepper;
mod path_point;
mod regularised;

pub use arc_length::Path;
pub use equilibrium::Equilibrium;
pub use load_stepper::{Increments, Statics};
pub use path_point::{ArcSteps, Left, Limit, PathPoint, Until};
pub use regularised::settle;
