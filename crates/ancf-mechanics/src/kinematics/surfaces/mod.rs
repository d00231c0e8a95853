//! Bicubic surfaces, and closest points of surfaces and their offsets.

mod bicubic_net;
mod closest_point;
mod offset;

pub(crate) use bicubic_net::BicubicNet;
pub(crate) use closest_point::{CONVEX, SurfaceSlopes, SurfaceValues, closest_point};
pub(crate) use offset::{OffsetValues, closest_offset_point, gap_slopes};
