//! Natural modes.

mod fine_meshes;
mod loaded_equilibria;
mod modes;
