//! Result columns and fields of states.

mod fields;
mod rows;
mod section_forces;

pub use fields::{Field, Fields, Station};
pub use rows::{Column, Rows};
pub(crate) use rows::{LOAD, RowHistory, TIME, columns};
