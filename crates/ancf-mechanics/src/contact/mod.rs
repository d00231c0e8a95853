//! Contact between bodies and with obstacles: search, penalty law and friction.

mod axis_curve;
mod beam_contact;
mod beam_search;
mod box_tree;
mod contact_tube;
mod crossing;
mod end_planes;
mod obstacle;
mod obstacle_contact;
mod obstacle_search;
mod point_contact;

pub use crate::laws::ContactLaw;
pub use beam_contact::BeamContact;
pub use beam_search::BeamContacts;
pub use contact_tube::ContactTube;
pub use obstacle::{Obstacle, ObstacleShape};
pub use obstacle_contact::ObstacleContact;
pub use obstacle_search::ObstacleContacts;
