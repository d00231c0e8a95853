//! Parts of loads: the trait of a kind, the builder of terms, loads per length, loads that a program adds.

mod axis_part;
mod builder;
mod context;
mod custom;
mod kind;

pub use axis_part::AxisPart;
pub(super) use axis_part::{end, start};
pub use builder::LoadBuilder;
pub(crate) use builder::patches;
pub use context::LoadContext;
pub use custom::CustomLoad;
pub use kind::{LoadKind, LoadObject};
