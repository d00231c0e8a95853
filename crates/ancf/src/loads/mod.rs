//! Loads: one file a kind, and one line each in `load.rs`.
//!
//! A kind of load implements [`LoadKind`]: data and units, place, needs and checks, terms of the equations of motion.

mod base_acceleration;
mod base_rotation;
mod distributed_force;
mod distributed_moment;
mod external;
mod fluid;
mod load;
mod parts;
mod point_force;
mod point_moment;
mod prestrain;
mod surface;

pub use crate::model::Capability;
pub use base_acceleration::BaseAcceleration;
pub use base_rotation::BaseRotation;
pub use distributed_force::DistributedForce;
pub use distributed_moment::DistributedMoment;
pub use external::ExternalLoad;
pub use fluid::Fluid;
pub use load::Load;
pub(crate) use parts::patches;
pub use parts::{AxisPart, CustomLoad, LoadBuilder, LoadContext, LoadKind, LoadObject};
pub use point_force::PointForce;
pub use point_moment::PointMoment;
pub use prestrain::Prestrain;
pub(crate) use prestrain::rigidity;
pub use surface::{
    EdgeForce, EdgeMoment, Gas, GasSurface, SurfaceFluid, SurfaceForce, SurfacePressure, SurfacePrestrain,
};
