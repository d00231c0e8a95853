//! Eigenvalue problems.

mod loaded_equilibria;
mod modes;
