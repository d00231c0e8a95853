//! FLOOR 1b: mechanics as terms. Elements, markers, constraints, forces; knows only [`system`](crate::system).

mod beam;
mod constraint;
mod force;
mod marker;
mod mesh;
mod quadrature;
mod section;
mod shape;

pub use beam::{Beam24, Profile};
pub use constraint::{Coincide, Perpendicular, Wrench};
pub use force::Force;
pub use marker::Marker;
pub use mesh::{BeamMesh, NodalVector};
pub use quadrature::gauss;
pub use section::{Directors, Lame, Moments, SectionLaw};
pub use shape::BeamShape;
