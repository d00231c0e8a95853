//! FLOOR 1b: mechanics as terms. Elements, markers, constraints, forces; knows only [`system`](crate::system).

mod beam;
mod cable;
mod cable_profile;
mod constraint;
mod line;
mod force;
mod marker;
mod mesh;
mod quadrature;
mod section;
mod shape;

pub use beam::{Beam24, Profile};
pub use cable::Cable12;
pub use cable_profile::{CableDamping, CableProfile, CableRule, CableSection};
pub use constraint::{Coincide, Perpendicular, Wrench};
pub use force::Force;
pub use marker::Marker;
pub use mesh::BeamMesh;
pub use quadrature::gauss;
pub use section::{Directors, Lame, Moments, SectionLaw};
pub use shape::BeamShape;
