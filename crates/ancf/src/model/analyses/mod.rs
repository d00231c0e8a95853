//! Analyses of a model, and its output.

mod analysis;
mod end_condition;
mod equilibrium;
mod initial;
mod output;
mod solver_settings;

pub use analysis::{Analysis, Dynamics, Scheme, Start, Step};
pub use end_condition::EndCondition;
pub use equilibrium::{About, Buckling, Modes, Path, Sense, Statics, Unstable};
pub use initial::{Initial, InitialStatics, Origin};
pub use output::{Output, Probe, Quantity};
pub use solver_settings::{EnergyGuard, NewtonMethod, Stop};
