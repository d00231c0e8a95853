//! Cases: design, objectives, execution on worker threads.

mod design;
mod gauges;
mod row;
mod workers;

pub use design::{CaseDesign, ParameterAxis};
pub use gauges::{ObjectiveGauges, reduce_column};
pub use row::{CaseOutcome, CaseRow};
pub use workers::run_cases;
