//! Topology and geometry of meshes of quadrilaterals and triangles.

use std::collections::BTreeMap;

use nalgebra::Vector3;

use super::face::Face;

/// Sine of the angle of two edges of an element at a corner below which it counts as degenerate.
const DEGENERATE: f64 = 0.05;
/// Largest number of edges at a node.
const VALENCE: usize = 12;
/// Distance of two nodes, relative to the shortest edge of the elements at them, below which they count as coincident.
const COINCIDENT: f64 = 1e-6;

/// Defect of a mesh. Nodes and elements are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TopologyDefect {
    /// Element with a node that does not exist.
    NoSuchNode {
        /// Element.
        element: usize,
        /// Number of the node.
        node: usize,
    },
    /// Element with a node twice.
    RepeatedNode {
        /// Element.
        element: usize,
        /// Node.
        node: usize,
    },
    /// Element with a corner whose edges are nearly parallel, have zero length, or are not convex.
    Degenerate {
        /// Element.
        element: usize,
        /// Node of the corner.
        node: usize,
    },
    /// Edge of more than two elements.
    Branch {
        /// Nodes of the edge.
        nodes: [usize; 2],
        /// Elements.
        elements: [usize; 3],
    },
    /// Neighbouring elements whose normals point to different sides.
    Orientation {
        /// Elements.
        elements: [usize; 2],
    },
    /// Two elements with the same nodes.
    Overlap {
        /// Elements.
        elements: [usize; 2],
    },
    /// Node of no element.
    Unused {
        /// Node.
        node: usize,
    },
    /// Node at which parts of the mesh meet without a common edge.
    Contact {
        /// Node.
        node: usize,
    },
    /// Two nodes at the same point.
    Coincident {
        /// Nodes.
        nodes: [usize; 2],
    },
    /// Node of more edges than supported.
    Valence {
        /// Node.
        node: usize,
    },
    /// Neighbouring elements whose normals have an angle above the limit.
    Kink {
        /// Elements.
        elements: [usize; 2],
        /// Angle in radians.
        angle: f64,
    },
}

/// Topology of a mesh.
#[derive(Clone, Debug)]
pub struct MeshTopology {
    /// Elements of each edge, with the sense of the edge in the element. Nodes of an edge are in ascending order.
    edges: BTreeMap<[usize; 2], Vec<(usize, bool)>>,
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

    /// Returns the first defect of a mesh. `crease` is the largest angle of the normals of neighbouring elements, in radians.
    pub fn defect(nodes: &[Vector3<f64>], elements: &[Face], crease: f64) -> Option<TopologyDefect> {
        for (element, face) in elements.iter().enumerate() {
            let own = face.nodes();
            if let Some(&node) = own.iter().find(|node| **node >= nodes.len()) {
                return Some(TopologyDefect::NoSuchNode { element, node });
            }
            if let Some(a) = (1..own.len()).find(|a| own[..*a].contains(&own[*a])) {
                return Some(TopologyDefect::RepeatedNode { element, node: own[a] });
            }
            if let Some(a) = degenerate_corner(face, nodes) {
                return Some(TopologyDefect::Degenerate { element, node: own[a] });
            }
        }
        let topology = Self::new(nodes.len(), elements);
        topology
            .defect_of_elements(elements)
            .or_else(|| topology.defect_of_edges(nodes, elements, crease))
            .or_else(|| topology.defect_of_nodes(nodes, elements))
    }

    fn defect_of_elements(&self, elements: &[Face]) -> Option<TopologyDefect> {
        let mut known = BTreeMap::new();
        elements.iter().enumerate().find_map(|(k, element)| {
            let mut nodes = element.nodes().to_vec();
            nodes.sort_unstable();
            known.insert(nodes, k).map(|before| TopologyDefect::Overlap { elements: [before, k] })
        })
    }

    fn defect_of_edges(
        &self,
        nodes: &[Vector3<f64>],
        elements: &[Face],
        crease: f64,
    ) -> Option<TopologyDefect> {
        self.edges.iter().find_map(|(edge, of)| match &of[..] {
            [(a, _), (b, _), (c, _), ..] => {
                Some(TopologyDefect::Branch { nodes: *edge, elements: [*a, *b, *c] })
            }
            [(a, sense), (b, other)] if sense == other => {
                Some(TopologyDefect::Orientation { elements: [*a, *b] })
            }
            [(a, _), (b, _)] => {
                let [m, n] = [a, b].map(|k| elements[*k].normal(nodes));
                let angle = m.cross(&n).norm().atan2(m.dot(&n));
                (angle > crease).then_some(TopologyDefect::Kink { elements: [*a, *b], angle })
            }
            _ => None,
        })
    }

    fn defect_of_nodes(&self, nodes: &[Vector3<f64>], elements: &[Face]) -> Option<TopologyDefect> {
        let (mut valence, mut open) = (vec![0; nodes.len()], vec![0; nodes.len()]);
        for (edge, of) in &self.edges {
            for node in edge {
                valence[*node] += 1;
                open[*node] += usize::from(of.len() == 1);
            }
        }
        for node in 0..nodes.len() {
            if self.at_node[node].is_empty() {
                return Some(TopologyDefect::Unused { node });
            }
            // An inner node has no open edge, and a node of a simple boundary has two.
            if open[node] > 2 {
                return Some(TopologyDefect::Contact { node });
            }
            if valence[node] > VALENCE {
                return Some(TopologyDefect::Valence { node });
            }
        }
        coincident(nodes, elements)
    }
}

/// Returns two nodes at the same point.
fn coincident(nodes: &[Vector3<f64>], elements: &[Face]) -> Option<TopologyDefect> {
    let edges = elements.iter().flat_map(Face::edges).map(|[a, b]| (nodes[a] - nodes[b]).norm());
    let near = COINCIDENT * edges.fold(f64::INFINITY, f64::min);
    let mut order: Vec<usize> = (0..nodes.len()).collect();
    order.sort_by(|a, b| nodes[*a].x.total_cmp(&nodes[*b].x));
    order.iter().enumerate().find_map(|(i, &a)| {
        let after = order[i + 1..].iter().take_while(|b| nodes[**b].x - nodes[a].x <= near);
        after
            .copied()
            .find(|&b| (nodes[a] - nodes[b]).norm() <= near)
            .map(|b| TopologyDefect::Coincident { nodes: [a.min(b), a.max(b)] })
    })
}

/// Returns the first corner of an element that is degenerate or not convex.
fn degenerate_corner(face: &Face, nodes: &[Vector3<f64>]) -> Option<usize> {
    let unit = face.normal(nodes);
    (0..face.nodes().len()).find(|&corner| {
        let [t, s] = face.corner_edges(corner, nodes);
        let sine = t.cross(&s).dot(&unit) / (t.norm() * s.norm());
        sine.partial_cmp(&DEGENERATE) != Some(std::cmp::Ordering::Greater)
    })
}
