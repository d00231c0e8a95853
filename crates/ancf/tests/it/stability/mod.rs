//! Natural modes.

mod followers;
mod loaded_equilibria;
mod modes;
