//! Models from text.

use ancf::Model;

/// Parses a model; panics with the errors and the text if it is invalid.
#[track_caller]
pub(crate) fn parse(text: &str) -> Model {
    Model::parse(text).unwrap_or_else(|errors| panic!("{errors}\n{text}"))
}
