//! Study files: parameters, sampling, objectives, checks.

mod checks;
mod columns;
mod distribution;
mod layout;
mod normal_quantile;
mod objective;
mod parameter;
mod places;
mod read_failure;
mod sampling;
mod sobol;
mod study;

pub use checks::{MAX_CASES, zip_errors};
pub use columns::TABLE_COLUMNS;
pub use distribution::ValueRule;
pub use layout::{CaseLayout, Combine};
pub use objective::{Objective, Objectives, Take};
pub use parameter::Parameter;
pub use places::check_places;
pub(crate) use read_failure::read_failure;
pub use sampling::Sampling;
pub use sobol::{MAX_SOBOL_DIMENSION, sobol_points};
pub use study::Study;
