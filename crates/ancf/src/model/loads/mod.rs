//! Loads of a model and their functions of time.

mod fluid;
mod load;

pub use fluid::Fluid;
pub use load::Load;
pub(crate) use load::Stretch;
