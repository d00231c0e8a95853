//! FLOOR 1a: what is done with equations of motion. Newton's method, time integration, equilibrium, modes, buckling;
//! knows no mechanics.

mod arc;
mod buckling;
mod dynamics;
mod equilibrium;
mod error;
mod krylov;
mod modes;
mod mover;
mod newmark;
mod newton;
mod path;
mod statics;
mod waypoint;

pub use buckling::{Critical, Sense, buckling};
pub use dynamics::{Dynamics, StepReport, consistent_start};
pub use equilibrium::Equilibrium;
pub use error::{EquilibriumError, Failure, SolveError};
pub use krylov::EigenError;
pub use modes::{Mode, Modes, modes};
pub use newmark::Newmark;
pub use newton::{Newton, Report, Stop};
pub use path::Path;
pub use statics::{Increments, Statics};
pub use waypoint::{ArcSteps, Left, Limit, PathPoint, Until};
