//! Applied forces and moments, springs and friction.

mod angle_ratio;
mod coordinate;
mod external;
mod follower;
mod force;
mod friction;
mod matrix_bushing;
mod measure_set;
mod moment;
mod spring;
mod strut;
mod strut_law;
mod swing_spring;

pub use coordinate::{CoordinateForce, Signal, SignalSource, StateForce};
pub use external::ExternalForce;
pub use follower::FollowerForce;
pub use force::Force;
pub use friction::{Bearing, Friction, FrictionLaw, ReactionFriction, Slip, TurnAxis};
pub use matrix_bushing::{BushingMatrices, MatrixBushing};
pub use moment::Moment;
pub use spring::Spring;
pub use strut::Strut;
pub use strut_law::{LinearStrut, StrutLaw};
pub use swing_spring::SwingSpring;
