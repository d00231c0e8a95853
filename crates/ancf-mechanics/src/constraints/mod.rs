//! Constraint equations of joints, with multipliers.

mod angle;
mod coincide_perpendicular;
mod drive;
mod measure;
mod slide;
mod target;
mod tie;

pub use angle::Angle;
pub use coincide_perpendicular::{Coincide, Perpendicular, Wrench};
pub use drive::Drive;
pub(crate) use measure::add_outer;
pub use measure::{Measure, Part};
pub use slide::Slide;
pub use target::Target;
pub use tie::Tie;
