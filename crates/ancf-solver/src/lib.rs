//! Solvers for equations of motion of flexible multibody systems.
//!
//! The equations are those of an index-3 differential-algebraic system,
//!
//! M a + f(q, v, t) + Φ_qᵀ λ = 0,  Φ(q, t) = 0,
//!
//! given as a sum of [`Term`](equations::Term)s. The crate assembles the sparse tangent, factorises it, and solves statics,
//! dynamics and eigenvalue problems. It contains no mechanics: elements, joints and loads are in `ancf-mechanics`.

pub mod dynamics;
pub mod eigen;
pub mod equations;
pub mod factor;
pub mod newton;
pub mod sparse;
pub mod statics;
