//! Analyses of a model, from assembly to result rows.

mod dynamics;
mod eigen;
mod equilibria;
mod error;
mod execute;
mod finer_equilibria;
mod run;

pub(crate) use dynamics::{COLUMNS, energy_warnings};
pub(crate) use eigen::{Kinks, NO_CRITICAL_LOAD};
pub use error::Error;
pub use execute::simulate;
pub use run::{
    Checkpoint, EigenvalueCount, Extension, Observer, Outcome, ResumeError, Simulation, SimulationBuilder,
    Summary,
};
pub(crate) use run::{
    SMALL_REMAINDER, StepCounts, TIME_TOLERANCE, error_control, fingerprint, hash_of, newton_method, outcome,
    started, turn_warning,
};
