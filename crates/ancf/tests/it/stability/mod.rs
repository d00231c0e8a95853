//! Natural modes.

mod carried_loads;
mod columns;
mod fine_meshes;
mod followers;
mod force_laws;
mod held_pressure;
mod loaded_equilibria;
mod modes;
