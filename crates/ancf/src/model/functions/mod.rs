//! Functions of time by which loads and drives are multiplied.

mod time_function;

pub(crate) use time_function::Clock;
pub use time_function::{TimeFunction, Varying};
