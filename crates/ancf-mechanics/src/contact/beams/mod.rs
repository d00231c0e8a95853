//! Contact of beams and cables with each other.

mod axis_curve;
mod beam_contact;
mod beam_search;
mod end_planes;

pub use beam_contact::BeamContact;
pub use beam_search::BeamContacts;
