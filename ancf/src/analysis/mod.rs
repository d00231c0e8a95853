//! FLOOR 1a: what is done with equations of motion. Newton's method, time integration, modes, buckling; knows no mechanics.

mod buckling;
mod dynamics;
mod error;
mod krylov;
mod modes;
mod newmark;
mod newton;

pub use buckling::{Critical, Sense, buckling};
pub use dynamics::{Dynamics, StepReport, consistent_start};
pub use error::{Failure, SolveError};
pub use krylov::EigenError;
pub use modes::{Mode, Modes, modes};
pub use newmark::Newmark;
pub use newton::{Newton, Report, Stop};
