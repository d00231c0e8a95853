//! FLOOR 1a: what is done with equations of motion. Newton's method, time integration, equilibrium, modes, buckling;
//! knows no mechanics.

mod adaptive;
mod arc;
mod buckling;
mod consistent;
mod current;
mod dynamics;
mod equilibrium;
mod error;
mod estimate;
mod floor;
mod krylov;
mod launch;
mod modes;
mod mover;
mod newton;
mod path;
mod scheme;
mod settle;
mod statics;
mod waypoint;

pub use adaptive::{Adaptive, Control};
pub use buckling::{Critical, Sense, buckling};
pub use consistent::{consistent_start, consistent_velocities};
pub use dynamics::{Dynamics, StepReport};
pub use equilibrium::Equilibrium;
pub use error::{EquilibriumError, Failure, SolveError};
pub use krylov::EigenError;
pub use modes::{Mode, Modes, modes};
pub use newton::{Newton, Report, Stop};
pub use path::Path;
pub use scheme::Scheme;
pub use settle::settle;
pub use statics::{Increments, Statics};
pub use waypoint::{ArcSteps, Left, Limit, PathPoint, Until};
