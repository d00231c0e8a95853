//! Functions of time that multiply loads and drives.

mod input;
mod time_function;

pub use input::Input;
pub(crate) use time_function::TimeMode;
pub use time_function::{TimeFunction, Varying};
