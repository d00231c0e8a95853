//! Study files: parameters, sampling, objectives, checks.

mod checks;
mod columns;
mod distribution;
mod normal_quantile;
mod objective;
mod parameter;
mod places;
mod read_failure;
mod sampling;
mod study;

pub use columns::TABLE_COLUMNS;
pub use distribution::ValueRule;
pub use objective::{Objective, Objectives, Take};
pub use parameter::Parameter;
pub(crate) use read_failure::read_failure;
pub use sampling::Sampling;
pub use study::{Combine, Study};
