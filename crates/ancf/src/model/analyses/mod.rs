//! Analyses of a model, and its output.

mod analysis;
mod equilibrium;
mod output;

pub use analysis::{Analysis, Dynamics, NewtonMethod, Scheme, Start, Step, Stop};
pub use equilibrium::{About, Buckling, Modes, Path, Sense, Statics};
pub use output::{Output, Probe, Quantity};
