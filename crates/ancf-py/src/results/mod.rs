//! Reports and geometry of results.

mod geometry;
pub(crate) mod report;

pub(crate) use geometry::{ModelGeometry, inertia_box, outline};
