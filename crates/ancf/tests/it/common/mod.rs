//! Helpers that several modules of tests use.

pub(crate) mod anything;
pub(crate) mod assertions;
pub(crate) mod continuum;
pub(crate) mod models;
pub(crate) mod random;
pub(crate) mod sample;
pub(crate) mod solutions;
