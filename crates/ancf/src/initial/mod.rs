//! Equilibria, and states from which motions start.

mod equilibrium_search;
mod initial_state;
mod report;
mod turn_counter;

pub(crate) use equilibrium_search::{EquilibriumSearch, equilibrium_failure, load_stepper};
pub(crate) use initial_state::InitialState;
pub use report::InitialReport;
pub(crate) use turn_counter::TurnCounter;
