//! Joints with chosen directions, and springs by matrices.

mod axes;
mod generic;
mod matrix_bushing;

pub use generic::{DirectionMotion, Generic};
pub use matrix_bushing::MatrixBushing;
