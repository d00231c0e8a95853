//! Points, closest points and forces common to contacts.

mod box_tree;
mod closest_contact;
mod contact_geometry;
mod end_bounds;
mod face_geometry;
mod foot;
mod limits;
mod point_contact;
mod thickness_deviation;

pub(super) use box_tree::{AlignedBox, BoxTree};
pub use closest_contact::ClosestContact;
pub(super) use closest_contact::{ContactPartners, ContactPose, sorted};
pub(super) use contact_geometry::SurfaceGeometry;
pub use contact_geometry::{ContactGeometry, ContactPoint};
pub(super) use end_bounds::{END_MARGIN, EndBounds};
pub(super) use face_geometry::{FaceGeometry, FaceNodes, FacePart, PartWeights};
pub(super) use foot::{Foot, NODE_TRANSITION, share};
pub(super) use limits::{JOINED_OVERLAP, MAX_SAMPLES, SMALLEST_DISTANCE, SPACING};
pub(super) use point_contact::{FootErrors, FootWeight, PointContact};
