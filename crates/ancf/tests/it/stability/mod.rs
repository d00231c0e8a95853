//! Natural modes.

mod carried_loads;
mod columns;
mod fine_meshes;
mod followers;
mod force_laws;
mod loaded_equilibria;
mod modes;
