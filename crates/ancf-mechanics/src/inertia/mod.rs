//! Forces and momenta of inertia, from the nodal vectors of a body and their mass matrix.

mod frame_rotation;
mod momentum;

pub use frame_rotation::{FrameInertia, FrameRotation};
pub use momentum::Momentum;

use crate::kinematics::NodalVector;

/// Visitor of the elements of a body: nodal vectors e_a, and the compact mass matrix M_ab of the kinetic energy
/// ½ Σ M_ab ė_a·ė_b.
pub type MassVisitor<'a> = dyn FnMut(&[NodalVector], &dyn Fn(usize, usize) -> f64) + 'a;
