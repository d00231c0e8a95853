//! Contact of points of bodies with the middle surfaces of thin shells.

mod bicubic_surface;
mod edge_planes;
mod surface_contact;
mod surface_search;

pub use surface_contact::SurfaceContact;
pub use surface_search::SurfaceContacts;
