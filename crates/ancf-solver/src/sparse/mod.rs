//! Sparse symmetric matrices: pattern, elimination order and supernodes.

mod elimination;
mod index_lists;
mod matrix;
mod ordering;
mod pattern;
mod subtrees;
mod supernodes;

pub(crate) use index_lists::IndexLists;
pub use matrix::SparseMatrix;
pub use pattern::Pattern;
pub(crate) use subtrees::{MIN_SUBTREE, Subtree, Subtrees, VectorSection, children, process_subtrees};
pub(crate) use supernodes::{QUAD, Quad, RowRun, Supernode, SupernodeShape, Supernodes};
