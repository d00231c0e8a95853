//! Simulations, and the states of their runs.

mod frames;
mod keep;
pub(crate) mod load;
pub(crate) mod pickle;
mod recorder;
mod simulation;
mod states;

pub(crate) use simulation::Simulation;
pub(crate) use states::States;
