//! The commands of `cargo xtask`.

pub(crate) mod benchmark;
pub(crate) mod dependencies;
pub(crate) mod fuzz;
pub(crate) mod hunt;
pub(crate) mod importers;
pub(crate) mod package;
pub(crate) mod pictures;
pub(crate) mod playground;
pub(crate) mod release;
pub(crate) mod schema;
pub(crate) mod test;
pub(crate) mod viewer;
