//! Natural modes.

mod carried_loads;
mod fine_meshes;
mod followers;
mod loaded_equilibria;
mod modes;
