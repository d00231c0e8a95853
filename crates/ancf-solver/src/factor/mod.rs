//! LDLᵀ factorisation of tangents with multipliers, iterative refinement and LU as a fallback; null spaces and dependences of
//! sparse rows.

mod conjugate_residuals;
mod dependences;
mod factor_measures;
mod factorisation;
mod inertia;
mod multifrontal;
mod null_space;
mod products;
mod scaled_lu;
mod scales;
mod skew_form;
mod skew_part;
mod sparse_row;

pub use dependences::{Dependence, dependences};
pub(crate) use factorisation::DETERMINED;
pub use factorisation::{Factor, FactorHistory, SingularMatrix};
pub use inertia::inertia;
pub(crate) use inertia::negative_eigenvalues;
pub use null_space::NullSpace;
pub(crate) use products::Products;
pub(crate) use scaled_lu::GeneralLu;
pub(crate) use skew_form::is_zero_on_motions;
pub use skew_part::add_skew_product;
pub(crate) use skew_part::solve_with_skew_part;
pub use sparse_row::{SparseRow, SparseVector, sparse_row};
