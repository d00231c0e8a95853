//! Errors of a model: key, found value, expected value.

mod error;
mod finding;
mod words;

pub use error::{ModelError, ModelErrors, Position};
pub use finding::{Finding, finding};
pub(crate) use finding::{formula_error, is_direction, no_direction};
pub(crate) use words::{listed, number, quoted};
pub use words::{nearest, percentage, short};
