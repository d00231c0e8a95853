//! Single elements, locking and convergence.

pub(super) mod locking;
pub(super) mod self_weight;
pub(super) mod single_element;
