//! FLOOR 1b: mechanics as terms. Elements, markers, constraints, forces; knows only [`system`](crate::system)
//! and [`function`](crate::function).

mod attachment;
mod axis;
mod cable;
mod cable_profile;
mod constraint;
mod curve;
mod drive;
mod element;
mod follower;
mod force;
mod formulation;
mod frame;
mod hyperelastic;
mod line;
mod marker;
mod mesh;
mod moment;
mod profile;
mod quadrature;
mod resultants;
mod section;
mod shape;
mod station;

pub use attachment::{Attachment, Directions};
pub use axis::ElementAxis;
pub use cable::Cable12;
pub use cable_profile::{CableDamping, CableProfile, CableRule, CableSection};
pub use constraint::{Coincide, Perpendicular, Wrench};
pub use curve::{Curve, Node, Spline};
pub use drive::Drive;
pub use element::{Beam24, Beam27, Element, Profile};
pub use follower::FollowerForce;
pub use force::Force;
pub use formulation::{CrossSection, Moments};
pub use hyperelastic::{NeoHookean, SectionPoint};
pub use marker::Marker;
pub use mesh::{BeamMesh, Blueprint, NodalVector};
pub use moment::Moment;
pub use profile::{Formulation, Medium};
pub use quadrature::{gauss, gauss2, gauss3};
pub use resultants::across;
pub use section::{Directors, Lame, SectionLaw, Stiffness};
pub use shape::{BeamShape, Interpolation, Kind, QuadraticShape};
pub use station::{Law, Station, StrainEnergy};
