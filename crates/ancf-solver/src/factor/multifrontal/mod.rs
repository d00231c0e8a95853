//! Supernodal LDLᵀ by the multifrontal method: dense fronts, their elimination, substitution and products.

mod dense;
mod elimination;
mod factor_values;
mod front;
mod large_front;
mod ldlt;
mod quads;
mod substitution;
mod work_space;

pub(super) use ldlt::Ldlt;
pub(super) use substitution::{SubtractProduct, SubtreeView};
