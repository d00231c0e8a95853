//! Joints with chosen directions, springs by matrices, sensors, and joints of programs.

mod axes;
mod custom;
mod generic;
mod matrix_bushing;
mod sensor;

pub use custom::CustomJoint;
pub use generic::{DirectionMotion, Generic};
pub use matrix_bushing::MatrixBushing;
pub use sensor::{Measure, Sensor};
