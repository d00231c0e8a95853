//! Factorisation LDLᵀ of the tangent with multipliers, refinement, and LU as the fallback.

mod dense;
mod factorisation;
mod front;
mod ldlt;
mod null_space;
mod substitution;

pub use factorisation::{Course, Factor, SingularMatrix};
pub use null_space::{Kernel, Sparse};
