//! Eigenvalue problems about a state: natural modes and critical loads.

mod buckling;
mod columns;
mod complex;
mod full_rows;
mod krylov;
mod modes;
mod operator;
mod pencil;
mod refinement;
mod softening;

pub use buckling::{CriticalLoad, CriticalLoads, LoadDirection, buckling};
pub use complex::{ComplexMode, DampedMode, DampedModes, damped_modes, nonconservative_modes, skew_ratio};
pub use modes::{EigenModes, Mode, SturmCount, modes, modes_memory};
pub use operator::EigenError;
pub use softening::softening;
