//! Contact between bodies and with obstacles: search, penalty law and friction.

mod beams;
mod obstacles;
mod parts;
mod surfaces;

pub use crate::laws::ContactLaw;
pub use beams::{BeamContact, BeamContacts};
pub use obstacles::{BallContact, Obstacle, ObstacleContact, ObstacleContacts, ObstacleShape};
pub use parts::{ClosestContact, ContactGeometry, ContactPoint};
pub use surfaces::{FaceContact, FaceContacts, ThinContact, ThinContacts};
