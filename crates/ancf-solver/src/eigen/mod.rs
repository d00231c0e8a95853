//! Eigenvalue problems about a state: natural modes and critical loads.

mod buckling;
mod columns;
mod full_rows;
mod krylov;
mod modes;
mod nonconservative;
mod operator;
mod pencil;
mod refinement;
mod skew_operator;
mod softening;

pub use buckling::{CriticalLoad, CriticalLoads, LoadDirection, buckling};
pub use modes::{EigenModes, Mode, SturmCount, modes};
pub use nonconservative::{ComplexMode, nonconservative_modes};
pub use operator::EigenError;
pub use skew_operator::skew_ratio;
