//! Contact of points of bodies with the middle surfaces of shells.

mod bicubic_surface;
mod edge_planes;
mod face_contact;
mod face_surface;
mod surface_search;
mod target;
mod thin_contact;

pub use face_contact::FaceContact;
pub use surface_search::SurfaceContacts;
pub use thin_contact::ThinContact;

use crate::contact::parts::{FaceGeometry, SurfaceGeometry};

/// Contact search between points of bodies and the surfaces of thin shells.
pub type ThinContacts = SurfaceContacts<SurfaceGeometry>;

/// Contact search between points of bodies and the surfaces of shear-deformable shells.
pub type FaceContacts = SurfaceContacts<FaceGeometry>;
