//! Imports between Rust files. Paths are resolved through re-exports to the file that defines the name.

mod attributes;
mod collect;
mod crates;
mod importer;
mod locals;
mod methods;
mod modules;
mod resolve;
mod tokens;
mod uses;
mod visit;

pub(super) use collect::imports;
