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
pub use error::Error;
pub use execute::simulate;
pub use observer::Observer;
pub use simulation::{Extension, Simulation, SimulationBuilder};
pub use summary::{EigenvalueCount, Outcome, Summary};
