//! JSON Schema of the model file, and checks of values against it.

mod address;
mod generate;
mod number_arrays;
mod published;
mod schema_check;
mod syntax;
mod units;
mod unknown;
mod valid_data;

pub(crate) use address::{PathStep, path_of, path_steps};
pub use generate::schema;
pub(crate) use generate::{SCHEMA, forms, found, keys, kind, tag};
pub use published::schema_text;
pub use schema_check::join;
pub(crate) use schema_check::{SchemaCheck, did_you_mean};
pub(crate) use syntax::{Document, position};
pub(crate) use unknown::unknown;
