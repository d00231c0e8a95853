//! Functions of time that multiply loads and drives.

mod time_function;

pub(crate) use time_function::TimeMode;
pub use time_function::{TimeFunction, Varying};
