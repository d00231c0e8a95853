//! Solutions of models: runs in memory, static equilibria and linear static displacements.

mod equilibrium;
mod linear;
mod run;

pub(crate) use equilibrium::equilibrium;
pub(crate) use linear::linear;
pub(crate) use run::{Run, distance};
