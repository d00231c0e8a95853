//! Eigenvalue problems about a state: natural modes and critical loads.

mod buckling;
mod krylov;
mod modes;

pub use buckling::{CriticalLoad, LoadDirection, buckling};
pub use krylov::EigenError;
pub use modes::{EigenModes, Mode, modes};
