//! File formats: SVG text, PNG, PDF.

pub(crate) mod pdf;
pub(crate) mod svg;
