//! Natural modes.

mod fine_meshes;
mod followers;
mod loaded_equilibria;
mod modes;
