//! Reports and geometry of results.

mod geometry;
pub(crate) mod report;
pub(crate) mod scalars;

pub(crate) use geometry::{ModelGeometry, inertia_box, outline};
