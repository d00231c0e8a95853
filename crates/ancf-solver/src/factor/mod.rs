//! LDLᵀ factorisation of tangents with multipliers, iterative refinement and LU as a fallback.

mod factorisation;
mod inertia;
mod multifrontal;
mod null_space;
mod products;
mod scaled_lu;
mod scales;

pub(crate) use factorisation::DETERMINED;
pub use factorisation::{Factor, FactorHistory, SingularMatrix};
pub use inertia::inertia;
pub use null_space::{NullSpace, SparseVector};
pub(crate) use products::Products;
pub(crate) use scaled_lu::GeneralLu;
