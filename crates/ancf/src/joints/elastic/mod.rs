//! Elastic joints: stiffness and damping without constraint equations.

mod bushing;
mod point_spring;

pub use bushing::Bushing;
pub use point_spring::PointSpring;
