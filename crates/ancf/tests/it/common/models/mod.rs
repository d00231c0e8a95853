//! Models and elements under test.

pub(crate) mod beams;
pub(crate) mod cables;
pub(crate) mod files;
pub(crate) mod held;
pub(crate) mod rod;
