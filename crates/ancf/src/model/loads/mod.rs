//! Loads of a model.

mod fluid;
mod load;

pub use fluid::Fluid;
pub use load::Load;
pub(crate) use load::Stretch;
