//! Graphs of groups of unknowns and the orders of their elimination.

mod coarsening;
mod dissection;
mod index_lists;
mod minimum_degree;
mod separation;
mod weighted_graph;

pub(super) use dissection::nested_dissection;
pub(crate) use index_lists::IndexLists;
pub(super) use minimum_degree::minimum_degree;
pub(super) use weighted_graph::WeightedGraph;
