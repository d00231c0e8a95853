//! Errors of a model: the key, what was found there, what is expected.

mod error;
mod finding;
mod words;

pub use error::{ModelError, ModelErrors, Position};
pub use finding::{Finding, finding};
pub use words::nearest;
pub(crate) use words::{listed, number, quoted};
