use std::collections::BTreeMap;

use super::face::Face;

/// Topology of a mesh.
#[derive(Clone, Debug)]
pub struct MeshTopology {
    /// Elements of each edge, with the sense of the edge in the element. Nodes of an edge are in ascending order.
    pub(super) edges: BTreeMap<[usize; 2], Vec<(usize, bool)>>,
    /// Elements at each node.
    at_node: Vec<Vec<usize>>,
}

impl MeshTopology {
    /// Creates the topology of elements with existing nodes.
    pub fn new(nodes: usize, elements: &[Face]) -> Self {
        let (mut edges, mut at_node) = (BTreeMap::<_, Vec<_>>::new(), vec![Vec::new(); nodes]);
        for (k, element) in elements.iter().enumerate() {
            for [from, to] in element.edges() {
                edges.entry([from.min(to), from.max(to)]).or_default().push((k, from < to));
                at_node[from].push(k);
            }
        }
        Self { edges, at_node }
    }

    /// Returns the elements at a node.
    pub fn at_node(&self, node: usize) -> &[usize] {
        &self.at_node[node]
    }

    /// Returns the elements of the edge between two nodes; an empty slice if there is no such edge.
    pub fn of_edge(&self, [a, b]: [usize; 2]) -> impl Iterator<Item = usize> + '_ {
        self.edges.get(&[a.min(b), a.max(b)]).into_iter().flatten().map(|(element, _)| *element)
    }

    /// Returns true if a node is on the boundary of the mesh.
    pub fn boundary(&self, nodes: usize) -> Vec<bool> {
        let mut boundary = vec![false; nodes];
        for ([a, b], of) in &self.edges {
            if of.len() == 1 {
                (boundary[*a], boundary[*b]) = (true, true);
            }
        }
        boundary
    }

    /// Returns the edges, nodes in ascending order, with the elements at each and the sense of the edge in them.
    pub fn edges(&self) -> impl Iterator<Item = ([usize; 2], &[(usize, bool)])> {
        self.edges.iter().map(|(edge, of)| (*edge, of.as_slice()))
    }

    /// Returns the edges of the boundary.
    pub fn boundary_edges(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        self.edges.iter().filter(|(_, of)| of.len() == 1).map(|(edge, _)| *edge)
    }

    /// Returns the nodes that have an edge with each node.
    pub fn neighbours(&self, nodes: usize) -> Vec<Vec<usize>> {
        let mut neighbours = vec![Vec::new(); nodes];
        for [a, b] in self.edges.keys() {
            neighbours[*a].push(*b);
            neighbours[*b].push(*a);
        }
        neighbours
    }

    /// Returns the number of the part of each element, from 0. Elements of a part are connected by edges.
    pub fn parts(&self, elements: usize) -> Vec<usize> {
        let mut neighbours = vec![Vec::new(); elements];
        for of in self.edges.values() {
            for pair in of.windows(2) {
                let [(a, _), (b, _)] = [pair[0], pair[1]];
                neighbours[a].push(b);
                neighbours[b].push(a);
            }
        }
        let (mut parts, mut count) = (vec![None; elements], 0);
        for first in 0..elements {
            let mut open = if parts[first].is_none() { vec![first] } else { continue };
            while let Some(k) = open.pop() {
                if parts[k].replace(count).is_none() {
                    open.extend(neighbours[k].iter().filter(|other| parts[**other].is_none()));
                }
            }
            count += 1;
        }
        parts.into_iter().flatten().collect()
    }
}
