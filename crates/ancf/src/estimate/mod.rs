//! Estimates of the discretisation error of results.
//!
//! The gap between each element and the exact rod under the section forces of the element is imposed on the structure. The
//! response to all gaps is the error of the whole state, from which those of all values follow.

mod discretisation_errors;
mod gap_field;
mod rod_sections;
mod sentence;
mod value_errors;

pub use discretisation_errors::{DiscretisationErrors, Resolution};
pub(crate) use gap_field::GapField;
pub use value_errors::{ProbeError, ValueError};
