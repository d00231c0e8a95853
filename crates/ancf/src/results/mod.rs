//! Result columns and fields of states.

mod angle_counter;
mod body_motion;
mod fields;
mod rows;
mod section_forces;

pub(crate) use angle_counter::AngleRates;
pub use fields::{Field, Fields, Station};
pub use rows::{Column, Rows};
pub(crate) use rows::{LOAD, RowHistory, TIME, columns};
