//! Contact of bodies with obstacles.

mod ball_contact;
mod crossing;
mod obstacle;
mod obstacle_contact;
mod obstacle_search;

pub use ball_contact::BallContact;
pub use obstacle::{Obstacle, ObstacleShape};
pub use obstacle_contact::ObstacleContact;
pub use obstacle_search::ObstacleContacts;
