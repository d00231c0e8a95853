//! Reference curves of beams, and the systems of equations of splines.

mod curve;
mod tridiagonal;

pub use curve::{ReferenceCurve, ReferenceNode, Spline};
pub use tridiagonal::{TridiagonalRow, solve_cyclic_tridiagonal, solve_tridiagonal};
