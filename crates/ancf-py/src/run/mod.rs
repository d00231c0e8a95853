//! Simulations, and the states of their runs.

mod frames;
mod keep;
pub(crate) mod load;
pub(crate) mod pickle;
mod recorder;
mod simulation;
mod states;
mod station_quantity;

pub(crate) use simulation::Simulation;
pub(crate) use states::{FIELD_MEMORY, States, checked_parts};
