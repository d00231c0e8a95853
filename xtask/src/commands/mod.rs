//! The commands of `cargo xtask`.

pub(crate) mod fuzz;
pub(crate) mod package;
pub(crate) mod schema;
pub(crate) mod speed;
pub(crate) mod supply;
pub(crate) mod test;
pub(crate) mod viewer;
