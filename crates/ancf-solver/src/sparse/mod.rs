//! Sparse symmetric matrices: pattern, elimination order and supernodes.

mod amalgamation;
mod carriers;
mod elimination;
mod graph;
mod matrix;
mod ordering;
mod pattern;
#[cfg(test)]
mod structures;
mod subtrees;
mod supernodes;
mod symbolic;

pub(crate) use carriers::ConstraintRow;
pub(crate) use graph::IndexLists;
pub use matrix::SparseMatrix;
pub(crate) use pattern::Border;
pub use pattern::{FactorStorage, Pattern};
pub(crate) use subtrees::{MIN_SUBTREE, Subtree, Subtrees, VectorSection, children, process_subtrees};
pub(crate) use supernodes::{QUAD, Quad, RowRun, Supernode, SupernodeShape, Supernodes, with_shape};
