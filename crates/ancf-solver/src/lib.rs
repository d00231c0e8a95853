//! Solvers for equations of motion of flexible multibody systems.
//!
//! The equations are those of an index-3 differential-algebraic system,
//!
//! M a + f(q, v, t) + Φ_qᵀ λ = 0,  Φ(q, t) = 0,
//!
//! given as a sum of [`Term`](equations::Term)s. The crate assembles and factorises the sparse tangent. It solves static,
//! dynamic and eigenvalue problems. Elements, joints and loads are in `ancf-mechanics`.

pub mod dynamics;
pub mod eigen;
pub mod equations;
pub mod factor;
pub mod newton;
pub mod sparse;
pub mod statics;
mod vectors;
