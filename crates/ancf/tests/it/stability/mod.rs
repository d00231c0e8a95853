//! Natural modes.

mod carried_loads;
mod fine_meshes;
mod followers;
mod free_modes;
mod loaded_equilibria;
mod modes;
