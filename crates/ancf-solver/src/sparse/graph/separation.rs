use std::cmp::Reverse;
use std::collections::{BinaryHeap, VecDeque};

use super::coarsening::shuffled;
use super::weighted_graph::WeightedGraph;
use crate::vectors::PseudoRandom;

/// Largest weight of a side, relative to the whole graph.
const LARGEST_SIDE: f64 = 0.6;
/// Largest number of passes of a refinement.
const PASSES: usize = 8;
/// Least and largest number of changes without improvement at which a pass ends.
const PATIENCE: [usize; 2] = [15, 100];

/// Part of a vertex: one of the two sides, or the separator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    Side(usize),
    Separator,
}

impl Part {
    const ALL: [Self; 3] = [Self::Side(0), Self::Side(1), Self::Separator];

    const fn index(self) -> usize {
        match self {
            Self::Side(side) => side,
            Self::Separator => 2,
        }
    }
}

/// Separation of a graph into two sides without edges between them, and their separator.
#[derive(Clone, Debug)]
pub(super) struct Separation {
    /// Part of each vertex.
    pub(super) parts: Vec<Part>,
    /// Weights of the sides and of the separator.
    weights: [u64; 3],
    /// Largest weight of a side.
    largest_side: u64,
}

impl Separation {
    /// Creates a separation of a graph with given parts.
    pub(super) fn new(graph: &WeightedGraph, parts: Vec<Part>) -> Self {
        let mut weights = [0; 3];
        for (part, vertex) in parts.iter().zip(0..) {
            weights[part.index()] += u64::from(graph.weight(vertex));
        }
        Self { parts, weights, largest_side: (LARGEST_SIDE * graph.total() as f64) as u64 }
    }

    /// Creates a separation whose first side grows from a random vertex to half of the graph.
    pub(super) fn grown(graph: &WeightedGraph, random: &mut PseudoRandom) -> Self {
        let mut parts = vec![Part::Side(1); graph.len()];
        let mut is_seen = vec![false; graph.len()];
        let (mut next, mut weight) = (VecDeque::new(), 0);
        for start in shuffled(graph.len(), random) {
            if !std::mem::replace(&mut is_seen[start as usize], true) {
                next.push_back(start);
            }
            while let Some(vertex) = next.pop_front().filter(|_| 2 * weight < graph.total()) {
                parts[vertex as usize] = Part::Side(0);
                weight += u64::from(graph.weight(vertex));
                for &other in graph.neighbours(vertex) {
                    if !std::mem::replace(&mut is_seen[other as usize], true) {
                        next.push_back(other);
                    }
                }
            }
        }
        for vertex in 0..graph.len() as u32 {
            let is_near =
                || graph.neighbours(vertex).iter().any(|&other| parts[other as usize] == Part::Side(0));
            if parts[vertex as usize] == Part::Side(1) && is_near() {
                parts[vertex as usize] = Part::Separator;
            }
        }
        Self::new(graph, parts)
    }

    /// Returns a measure that is least for the best separation: surplus weight of a side, weight of the separator, difference of the sides.
    pub(super) fn cost(&self) -> [u64; 3] {
        let [one, other, separator] = self.weights;
        [one.max(other).saturating_sub(self.largest_side), separator, one.abs_diff(other)]
    }

    /// Returns true if both sides have vertices.
    pub(super) fn has_sides(&self) -> bool {
        self.weights[0] > 0 && self.weights[1] > 0
    }

    /// Returns the vertices of each part among the given ones, which the graph consists of.
    pub(super) fn vertices(&self, of: &[u32]) -> [Vec<u32>; 3] {
        let pairs = || of.iter().zip(&self.parts);
        Part::ALL.map(|part| pairs().filter(|(_, own)| **own == part).map(|(vertex, _)| *vertex).collect())
    }

    /// Moves vertices of the separator into the sides while this improves the separation.
    ///
    /// Source: Fiduccia & Mattheyses (1982), for vertex separators Ashcraft & Liu (1997).
    pub(super) fn refine(&mut self, graph: &WeightedGraph) {
        for _ in 0..PASSES {
            let before = self.cost();
            Pass::new(self, graph).run();
            if self.cost() >= before {
                break;
            }
        }
    }

    fn set(&mut self, graph: &WeightedGraph, vertex: u32, part: Part) -> Part {
        let weight = u64::from(graph.weight(vertex));
        let before = std::mem::replace(&mut self.parts[vertex as usize], part);
        self.weights[before.index()] -= weight;
        self.weights[part.index()] += weight;
        before
    }
}

/// Pass of a refinement, in which each vertex leaves the separator at most once.
struct Pass<'a> {
    own: &'a mut Separation,
    graph: &'a WeightedGraph,
    /// Decrease of the separator if a vertex moves to each side.
    gains: Vec<[i64; 2]>,
    /// Vertices of the separator by their gains. Entries with an earlier gain are invalid.
    queues: [BinaryHeap<(i64, u32)>; 2],
    is_moved: Vec<bool>,
    /// Changed vertices with their parts before.
    changes: Vec<(u32, Part)>,
}

impl<'a> Pass<'a> {
    fn new(own: &'a mut Separation, graph: &'a WeightedGraph) -> Self {
        let count = graph.len();
        let separator = (0..count as u32).filter(|&vertex| own.parts[vertex as usize] == Part::Separator);
        let separator: Vec<u32> = separator.collect();
        let (gains, is_moved) = (vec![[0; 2]; count], vec![false; count]);
        let mut pass = Self { own, graph, gains, queues: Default::default(), is_moved, changes: Vec::new() };
        separator.into_iter().for_each(|vertex| pass.enter(vertex));
        pass
    }

    /// Moves vertices in the order of their gains, also to worse separations, and returns to the best one.
    fn run(mut self) {
        let patience = (self.graph.len() / 100).clamp(PATIENCE[0], PATIENCE[1]);
        let (mut best, mut since) = ((self.own.cost(), 0), 0);
        while since <= patience
            && let Some((vertex, side)) = self.next()
        {
            self.leave(vertex, side);
            let cost = self.own.cost();
            since += 1;
            if cost < best.0 {
                (best, since) = ((cost, self.changes.len()), 0);
            }
        }
        for (vertex, part) in self.changes.drain(best.1..).rev() {
            self.own.set(self.graph, vertex, part);
        }
    }

    /// Returns the vertex of the separator with the largest gain, and its new side.
    fn next(&mut self) -> Option<(u32, usize)> {
        let Self { own, graph, gains, queues, is_moved, .. } = self;
        let mut best = None;
        for (side, queue) in queues.iter_mut().enumerate() {
            let is_valid = |&(gain, vertex): &(i64, u32)| {
                let at = vertex as usize;
                own.parts[at] == Part::Separator && !is_moved[at] && gains[at][side] == gain
            };
            while queue.peek().is_some_and(|entry| !is_valid(entry)) {
                queue.pop();
            }
            let Some(&(gain, vertex)) = queue.peek() else { continue };
            let weight = own.weights[side];
            let fits = weight + u64::from(graph.weight(vertex)) <= own.largest_side;
            let entry = ((gain, Reverse(weight)), vertex, side);
            if (fits || weight < own.weights[1 - side]) && best.is_none_or(|best| entry > best) {
                best = Some(entry);
            }
        }
        best.map(|(_, vertex, side)| (vertex, side))
    }

    /// Moves a vertex from the separator to a side. Its neighbours on the other side enter the separator.
    fn leave(&mut self, vertex: u32, side: usize) {
        let graph = self.graph;
        self.change(vertex, Part::Side(side));
        self.is_moved[vertex as usize] = true;
        for &near in graph.neighbours(vertex) {
            match self.own.parts[near as usize] {
                Part::Side(own) if own != side => {
                    self.change(near, Part::Separator);
                    let weight = i64::from(graph.weight(near));
                    graph.neighbours(near).iter().for_each(|&other| self.add_gain(other, side, weight));
                    self.enter(near);
                }
                Part::Separator => self.add_gain(near, 1 - side, -i64::from(graph.weight(vertex))),
                Part::Side(_) => {}
            }
        }
    }

    fn change(&mut self, vertex: u32, part: Part) {
        let before = self.own.set(self.graph, vertex, part);
        self.changes.push((vertex, before));
    }

    /// Computes the gains of a vertex of the separator.
    fn enter(&mut self, vertex: u32) {
        if self.is_moved[vertex as usize] {
            return;
        }
        for side in 0..2 {
            let opposite = Part::Side(1 - side);
            let near = self.graph.neighbours(vertex).iter();
            let entering = near.filter(|&&other| self.own.parts[other as usize] == opposite);
            let loss: i64 = entering.map(|&other| i64::from(self.graph.weight(other))).sum();
            self.set_gain(vertex, side, i64::from(self.graph.weight(vertex)) - loss);
        }
    }

    fn add_gain(&mut self, vertex: u32, side: usize, change: i64) {
        if self.own.parts[vertex as usize] == Part::Separator && !self.is_moved[vertex as usize] {
            self.set_gain(vertex, side, self.gains[vertex as usize][side] + change);
        }
    }

    fn set_gain(&mut self, vertex: u32, side: usize, gain: i64) {
        self.gains[vertex as usize][side] = gain;
        self.queues[side].push((gain, vertex));
    }
}
