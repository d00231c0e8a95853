//! Loads of a model.

mod custom;
mod fluid;
mod load;

pub use custom::{CustomLoad, LoadKind, LoadObject};
pub use fluid::Fluid;
pub use load::Load;
pub(crate) use load::Stretch;
