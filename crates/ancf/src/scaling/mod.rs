//! Models in other units.

mod joints;
mod model;

pub(crate) use model::number;
