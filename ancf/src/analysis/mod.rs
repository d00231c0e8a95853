//! FLOOR 1a: what is done with equations of motion. Newton's method, time integration and
//! equilibrium; knows no mechanics.

mod arc;
mod dynamics;
mod equilibrium;
mod error;
mod mover;
mod newmark;
mod newton;
mod path;
mod statics;
mod waypoint;

pub use dynamics::{Dynamics, StepReport, consistent_start};
pub use equilibrium::Equilibrium;
pub use error::{EquilibriumError, Failure, SolveError};
pub use newmark::Newmark;
pub use newton::{Newton, Report, Stop};
pub use path::Path;
pub use statics::{Increments, Statics};
pub use waypoint::{ArcSteps, Left, Limit, PathPoint, Until};
