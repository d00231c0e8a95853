//! Configuration, source files and findings, shared by the parsers of all languages and the rules.

pub(super) mod config;
pub(super) mod import;
pub(super) mod source;
pub(super) mod violation;
