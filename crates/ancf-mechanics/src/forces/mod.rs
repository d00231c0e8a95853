//! Applied forces and moments, springs and friction.

mod external;
mod follower;
mod force;
mod friction;
mod moment;
mod spring;
mod strut;
mod swing_spring;

pub use external::ExternalForce;
pub use follower::FollowerForce;
pub use force::Force;
pub use friction::Friction;
pub use moment::Moment;
pub use spring::Spring;
pub use strut::Strut;
pub use swing_spring::SwingSpring;
