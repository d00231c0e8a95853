//! Packages of a release: crates, source archive, program archives, wheels, and their documents.

pub(crate) mod archive;
pub(crate) mod build;
pub(crate) mod checksums;
pub(crate) mod crates;
pub(crate) mod interface;
pub(crate) mod licences;
pub(crate) mod materials;
pub(crate) mod program;
pub(crate) mod release;
pub(crate) mod source;
pub(crate) mod wheel;
