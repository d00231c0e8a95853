//! Table of costs per element: measured values with targets, other programs and lower bounds.

mod contact_rows;
mod large_model_rows;
pub mod lower_bounds;
mod motion_rows;
pub mod process;
mod row;
mod rows;
mod shell_rows;
mod table_report;

pub use row::{LimitingResource, LowerBound, MeasuredValue, RowSpec, RowUnit, TableRow};
pub use rows::{RowMeasurements, SMALL, STEPS};
pub use table_report::TableReport;
