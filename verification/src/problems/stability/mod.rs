//! Buckling, limit points and snap-through.

pub(super) mod columns;
pub(super) mod euler_column;
pub(super) mod lateral_buckling;
pub(super) mod lees_frame;
