//! Result columns and fields of states.

mod angle_counter;
mod body_motion;
mod column;
mod fields;
mod powers;
mod rows;
mod section_forces;

pub(crate) use angle_counter::{AngleRates, counted_angles};
pub use column::Column;
pub use fields::{Field, Fields, Station};
pub use rows::Rows;
pub(crate) use rows::{LOAD, RESULTANTS, RowHistory, SURFACE_STRESS, TIME, columns};
