//! Natural modes.

mod loaded_equilibria;
mod modes;
