//! Finite elements: ANCF beams and cables, and rigid bodies in natural coordinates.

mod beam;
mod cable;
mod cable_products;
mod cable_profile;
mod cable_rounding;
mod cable_step;
mod prestrain;
mod profile;
mod rigid;
mod rigid_term;
mod station;
mod station_products;
mod station_step;

pub use beam::{Beam24, Beam27, BeamElement, Profile};
pub(crate) use cable::CRUSHED;
pub use cable::Cable12;
pub(crate) use cable_profile::CableStation;
pub use cable_profile::{CableDamping, CableProfile, CableRule, CableSection};
pub use prestrain::Prestrain;
pub(crate) use prestrain::{
    Change, ElementPlace, PrestrainTerm, Prestrained, Prestrains, section_prestrains,
};
pub use profile::{BeamMaterial, TwoNodeLaw};
pub use rigid::{RigidBody, is_physical_inertia};
pub(crate) use rigid_term::RigidTerm;
pub use station::{BeamStation, StationLaw, StrainEnergy};
