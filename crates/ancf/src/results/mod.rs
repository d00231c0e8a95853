//! Result columns and fields of states.

mod angle_counter;
mod body_motion;
mod column;
mod fields;
mod powers;
mod row_columns;
mod rows;
mod section_forces;

pub(crate) use angle_counter::{AngleRates, counted_angles};
pub use column::Column;
pub use fields::{Field, Fields, Station};
pub(crate) use row_columns::{LOAD, RESULTANTS, SURFACE_STRESS, TIME, columns};
pub(crate) use rows::RowHistory;
pub use rows::Rows;
