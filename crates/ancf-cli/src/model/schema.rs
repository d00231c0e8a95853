//! `ancf schema`: the JSON Schema of model files.

use crate::terminal::{Ended, print_output};

/// Examples of the help.
pub const SCHEMA_EXAMPLES: &str = "\
Examples:
  ancf schema > model.schema.json

With `#:schema ./model.schema.json` in the first line of a model, editors complete keys and mark errors.";

/// Prints the schema.
pub fn print_schema() -> Ended {
    print_output(&ancf::schema::schema_text());
    Ended::Done
}
