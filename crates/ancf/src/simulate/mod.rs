//! Analyses of a model, from assembly to result rows.

mod checkpoint;
mod dynamics;
mod eigen;
mod equilibria;
mod error;
mod execute;
mod observer;
mod outcome;
mod run;
mod simulation;
mod step_control;
mod summary;

pub use checkpoint::{Checkpoint, ResumeError};
pub(crate) use checkpoint::{StepCounts, fingerprint, hash_of};
pub(crate) use dynamics::{COLUMNS, energy_warnings};
pub use error::Error;
pub use execute::simulate;
pub use observer::Observer;
pub(crate) use outcome::outcome;
pub(crate) use run::turn_warning;
pub use simulation::{Extension, Simulation, SimulationBuilder};
pub(crate) use step_control::{SMALL_REMAINDER, TIME_TOLERANCE, error_control, newton_method, started};
pub use summary::{EigenvalueCount, Outcome, Summary};
