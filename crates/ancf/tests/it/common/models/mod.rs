//! Models and elements under test.

pub(crate) mod beams;
pub(crate) mod cables;
pub(crate) mod files;
pub(crate) mod jointed_body;
pub(crate) mod rod;
mod text;

pub(crate) use text::parse;
