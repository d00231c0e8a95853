//! Closest points of surfaces.

mod closest_point;

pub(crate) use closest_point::{CONVEX, SurfaceValues, closest_point, derivatives};
