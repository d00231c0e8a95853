//! FLOOR 1a: what is done with equations of motion. Newton's method and time integration; knows no mechanics.

mod adaptive;
mod consistent;
mod dynamics;
mod error;
mod estimate;
mod floor;
mod launch;
mod newton;
mod scheme;

pub use adaptive::{Adaptive, Control};
pub use consistent::{consistent_start, consistent_velocities};
pub use dynamics::{Dynamics, StepReport};
pub use error::{Failure, SolveError};
pub use newton::{Newton, Report, Stop};
pub use scheme::Scheme;
