//! Sparse symmetric matrices: pattern, elimination order and supernodes.

mod elimination;
mod index_lists;
mod matrix;
mod ordering;
mod pattern;
mod subtrees;
mod supernodes;

pub(crate) use index_lists::Lists;
pub use matrix::SparseMatrix;
pub use pattern::Pattern;
pub(crate) use subtrees::{Branch, Branches, LEAST, Stretch, children, fork};
pub(crate) use supernodes::{LANES, Panel, Panels, Quad, Run, Shape};
