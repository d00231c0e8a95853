//! Eigenvalue analyses: natural modes, damped modes and critical loads.

mod critical;
mod damped;
mod finer_values;
mod kinks;
mod natural;
mod shapes;

pub(crate) use critical::NO_CRITICAL_LOAD;
pub(crate) use kinks::Kinks;
pub(crate) use shapes::{BUCKLING_COLUMNS, DAMPED_COLUMNS, MODE_COLUMNS, columns};
