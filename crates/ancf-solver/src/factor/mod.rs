//! LDLᵀ factorisation of tangents with multipliers, iterative refinement and LU as a fallback.

mod dense;
mod factorisation;
mod front;
mod inertia;
mod large_front;
mod ldlt;
mod null_space;
mod products;
mod quads;
mod scaled_lu;
mod scales;
mod substitution;

pub(crate) use factorisation::DETERMINED;
pub use factorisation::{Factor, FactorHistory, SingularMatrix};
pub use inertia::inertia;
pub use null_space::{NullSpace, SparseVector};
pub(crate) use products::Products;
pub(crate) use scaled_lu::GeneralLu;
