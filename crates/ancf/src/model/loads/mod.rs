//! Loads of a model and their functions of time.

mod fluid;
mod load;
mod time_function;

pub use fluid::Fluid;
pub use load::Load;
pub(crate) use load::Stretch;
pub(crate) use time_function::Clock;
pub use time_function::{TimeFunction, Varying};
