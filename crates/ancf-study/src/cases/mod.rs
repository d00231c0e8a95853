//! Cases: design, objectives, execution on worker threads.

mod base_model;
mod design;
mod gauges;
mod row;
mod workers;

pub use base_model::BaseModel;
pub use design::{CaseDesign, ParameterAxis};
pub use gauges::{ObjectiveGauges, reduce_column};
pub use row::{CaseOutcome, CaseRow};
pub use workers::run_cases;
