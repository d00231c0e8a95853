//! Solutions of models: runs in memory, static equilibria, linear static displacements, momenta.

mod equilibrium;
mod linear;
mod momenta;
mod run;

pub(crate) use equilibrium::equilibrium;
pub(crate) use linear::linear;
pub(crate) use momenta::{momenta, recorded_momenta};
pub(crate) use run::{Run, SOLVER_COLUMNS, assert_same_columns, distance};
