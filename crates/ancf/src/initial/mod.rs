//! Equilibria, and states from which motions start.

mod equilibrium_search;
mod given_state;
mod initial_state;
mod origin;
mod report;
mod start_state;
mod static_start;
mod turn_counter;

pub(crate) use equilibrium_search::{EquilibriumSearch, equilibrium_failure, load_stepper};
pub use given_state::GivenState;
pub(crate) use given_state::{coordinate_units, units};
pub(crate) use initial_state::InitialState;
pub use report::InitialReport;
pub use start_state::StartState;
pub(crate) use start_state::require_alignment;
pub(crate) use static_start::StaticStart;
pub(crate) use turn_counter::TurnCounter;
