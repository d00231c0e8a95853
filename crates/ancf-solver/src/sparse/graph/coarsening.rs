use std::cmp::Reverse;

use super::weighted_graph::WeightedGraph;
use crate::vectors::PseudoRandom;

/// Largest weight of a merged vertex, relative to the whole graph.
const LARGEST: f64 = 0.05;
/// Share of the vertices above which a coarser graph is of no use.
const USELESS: f64 = 0.9;

/// Graph whose vertices are pairs of vertices of a finer graph.
pub(super) struct CoarseGraph {
    pub(super) graph: WeightedGraph,
    /// Vertex of the coarse graph that contains each vertex of the finer one.
    pub(super) of: Vec<u32>,
}

impl CoarseGraph {
    /// Merges vertices that heavy edges connect. `None` if most of them have no such edge.
    ///
    /// Source: Karypis & Kumar (1998), heavy-edge matching.
    pub(super) fn new(fine: &WeightedGraph, random: &mut PseudoRandom) -> Option<Self> {
        let largest = (LARGEST * fine.total() as f64) as u32;
        let mut of: Vec<Option<u32>> = vec![None; fine.len()];
        let mut pairs: Vec<[u32; 2]> = Vec::new();
        for vertex in shuffled(fine.len(), random) {
            if of[vertex as usize].is_some() {
                continue;
            }
            let fits = |other: u32| {
                of[other as usize].is_none() && fine.weight(other) + fine.weight(vertex) <= largest
            };
            let free = fine.edges(vertex).filter(|(other, _)| fits(*other));
            let heaviest = free.max_by_key(|&(other, edge)| (edge, Reverse(fine.weight(other))));
            let mate = heaviest.map_or(vertex, |(other, _)| other);
            let pair = [vertex, mate];
            pair.iter().for_each(|&member| of[member as usize] = Some(pairs.len() as u32));
            pairs.push(pair);
        }
        if pairs.len() as f64 > USELESS * fine.len() as f64 {
            return None;
        }
        let of: Vec<u32> = of.into_iter().flatten().collect();
        Some(Self { graph: merged(fine, &pairs, &of), of })
    }
}

/// Returns the graph of the pairs, in which edges between the same pairs are added.
fn merged(fine: &WeightedGraph, pairs: &[[u32; 2]], of: &[u32]) -> WeightedGraph {
    let mut graph = WeightedGraph::new();
    // Pair to which an edge was found last, and the place of this edge.
    let mut found: Vec<Option<(u32, usize)>> = vec![None; pairs.len()];
    let mut edges: Vec<(u32, u32)> = Vec::new();
    for (&[one, mate], own) in pairs.iter().zip(0..) {
        edges.clear();
        let members = if one == mate { &[one][..] } else { &[one, mate] };
        for (other, weight) in members.iter().flat_map(|&member| fine.edges(member)) {
            let other = of[other as usize];
            match found[other as usize] {
                _ if other == own => {}
                Some((last, place)) if last == own => edges[place].1 += weight,
                _ => {
                    found[other as usize] = Some((own, edges.len()));
                    edges.push((other, weight));
                }
            }
        }
        let weight = members.iter().map(|&member| fine.weight(member)).sum();
        graph.push(weight, edges.iter().copied());
    }
    graph
}

/// Returns the vertices in a random order.
pub(super) fn shuffled(count: usize, random: &mut PseudoRandom) -> Vec<u32> {
    let mut order: Vec<u32> = (0..count as u32).collect();
    (1..count).rev().for_each(|at| order.swap(at, random.below(at + 1)));
    order
}
