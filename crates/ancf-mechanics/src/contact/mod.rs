//! Contact between bodies and with obstacles: search, penalty law and friction.

mod beam_contact;
mod contact_law;
mod contact_search;
mod crossing;
mod obstacle;

pub use beam_contact::BeamContact;
pub use contact_law::ContactLaw;
pub use contact_search::{BeamContacts, ContactTube, ObstacleContacts};
pub use obstacle::{Obstacle, ObstacleContact, ObstacleShape};
