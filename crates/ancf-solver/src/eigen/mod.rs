//! Eigenvalue problems about a state: natural modes and critical loads.

mod buckling;
mod krylov;
mod modes;
mod pencil;
mod refinement;

pub use buckling::{CriticalLoad, CriticalLoads, LoadDirection, buckling};
pub use krylov::EigenError;
pub use modes::{EigenModes, Mode, SturmCount, modes};
