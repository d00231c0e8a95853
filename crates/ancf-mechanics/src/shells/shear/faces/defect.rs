use std::collections::BTreeMap;

use nalgebra::Vector3;

use super::face::Face;
use super::mesh_topology::MeshTopology;
use super::near_nodes::near_nodes;

/// Sine of the angle of two edges of an element at a corner below which it counts as degenerate.
const DEGENERATE: f64 = 0.05;
/// Largest number of edges at a node.
const VALENCE: usize = 12;
/// Distance of two nodes, relative to the shortest edge, below which they count as coincident.
const COINCIDENT: f64 = 1e-6;
/// Distance of two nodes of the boundary, relative to the shortest edge, below which there is a crack between them.
const GAP: f64 = 0.01;

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
    /// Elements that no sequence of neighbouring elements connects.
    Disconnected {
        /// Elements.
        elements: [usize; 2],
        /// Nodes of both parts that are much nearer than the shortest edge, if there are such.
        near: Option<[usize; 2]>,
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

impl MeshTopology {
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
            if self.at_node(node).is_empty() {
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
        self.coincident(nodes).or_else(|| self.disconnected(nodes, elements.len()))
    }

    /// Returns two nodes at the same point.
    fn coincident(&self, nodes: &[Vector3<f64>]) -> Option<TopologyDefect> {
        let near = COINCIDENT * self.shortest_edge(nodes);
        near_nodes(nodes, 0..nodes.len(), near).map(|nodes| TopologyDefect::Coincident { nodes })
    }

    fn disconnected(&self, nodes: &[Vector3<f64>], elements: usize) -> Option<TopologyDefect> {
        let parts = self.parts(elements);
        let other = parts.iter().position(|part| *part != 0)?;
        Some(TopologyDefect::Disconnected { elements: [0, other], near: self.gap(nodes) })
    }

    /// Returns two nodes of the boundary that are much nearer than the shortest edge: the mesh has a crack there.
    pub fn gap(&self, nodes: &[Vector3<f64>]) -> Option<[usize; 2]> {
        let boundary = self.boundary(nodes.len());
        near_nodes(nodes, (0..nodes.len()).filter(|node| boundary[*node]), GAP * self.shortest_edge(nodes))
    }

    /// Returns the length of the shortest edge.
    pub fn shortest_edge(&self, nodes: &[Vector3<f64>]) -> f64 {
        self.edges.keys().map(|[a, b]| (nodes[*a] - nodes[*b]).norm()).fold(f64::INFINITY, f64::min)
    }
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
