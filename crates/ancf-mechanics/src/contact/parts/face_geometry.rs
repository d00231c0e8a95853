use nalgebra::Vector3;
use smallvec::SmallVec;

use crate::shells::{Face, MeshTopology, NODES, Shape, ShearShellMesh};

/// First coordinate and reference position of each node of an element.
pub(in crate::contact) type FaceNodes = SmallVec<[(usize, Vector3<f64>); NODES]>;

/// Middle surface of an element of a shear-deformable shell, with its neighbours.
#[derive(Clone, Debug)]
pub struct FaceGeometry {
    pub(in crate::contact) shape: Shape,
    pub(in crate::contact) nodes: FaceNodes,
    /// Number of the element in its shell.
    number: usize,
    /// Half the thickness at the nodes less the smallest one, if it varies.
    pub(in crate::contact) excess: Option<SmallVec<[f64; NODES]>>,
    /// Element beyond each edge.
    beyond: [Option<usize>; NODES],
    fans: [Fan; NODES],
}

/// Elements at a node in their order around it.
#[derive(Clone, Debug, Default)]
struct Fan {
    elements: SmallVec<[usize; 6]>,
    /// True if the last element has an edge with the first one.
    is_closed: bool,
}

/// Part of an element: its surface, an edge or a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::contact) enum FacePart {
    Surface,
    /// Edge from a corner to the next one.
    Edge(usize),
    Node(usize),
}

impl FacePart {
    /// Number of parts of an element.
    pub(in crate::contact) const COUNT: usize = 1 + 2 * NODES;

    /// Returns the number of the part, from 0.
    pub(in crate::contact) const fn number(self) -> usize {
        match self {
            Self::Surface => 0,
            Self::Edge(k) => 1 + k,
            Self::Node(k) => 1 + NODES + k,
        }
    }

    /// Returns the part with a number.
    pub(in crate::contact) const fn new(number: usize) -> Self {
        match number {
            0 => Self::Surface,
            k if k <= NODES => Self::Edge(k - 1),
            k => Self::Node(k - 1 - NODES),
        }
    }
}

/// Weights of the distances to the parts of an element, by their numbers.
pub(in crate::contact) type PartWeights = [f64; FacePart::COUNT];

impl FaceGeometry {
    /// Returns the elements of a mesh. `excess` is half a relative thickness less the smallest one.
    pub(super) fn all(mesh: &ShearShellMesh, excess: impl Fn(f64) -> f64) -> Vec<Self> {
        let faces = mesh.faces();
        let topology = MeshTopology::new(mesh.nodes(), faces);
        let of = |(number, face): (usize, &Face)| {
            let mut beyond = [None; NODES];
            for (k, edge) in face.edges().enumerate() {
                beyond[k] = topology.of_edge(edge).find(|element| *element != number);
            }
            let fan = |k: usize| face.nodes().get(k).map(|node| Fan::new(*node, faces, &topology));
            let fans = std::array::from_fn(|k| fan(k).unwrap_or_default());
            let nodes = mesh.corners(number).into_iter().collect();
            let scales = mesh.relative_thicknesses(number);
            let excess = scales.map(|scales| scales.into_iter().map(&excess).collect());
            Self { shape: face.shape(), nodes, number, excess, beyond, fans }
        };
        faces.iter().enumerate().map(of).collect()
    }

    /// Returns the weights of the contact potentials of the parts in the potential of a point.
    ///
    /// The potential of a point near a mesh is Σ U(surfaces) − Σ U(inner edges) + Σ U(inner nodes), each with the distance from
    /// that part. It counts a closest point on an edge or a node once (inclusion and exclusion). Each element has its
    /// share of the edges and nodes, ½ of an edge. `is_joined` is true for elements without contact with the point. A point
    /// whose closest point is at an edge or a node of such an element has no potential.
    pub(in crate::contact) fn weights(&self, is_joined: impl Fn(usize) -> bool) -> PartWeights {
        let mut weights = [0.0; FacePart::COUNT];
        weights[FacePart::Surface.number()] = 1.0;
        let (count, mut of_edges) = (self.nodes.len(), [0.0; NODES]);
        for k in 0..count {
            of_edges[k] = self.beyond[k].map_or(0.0, |other| if is_joined(other) { -1.0 } else { -0.5 });
        }
        for k in 0..count {
            weights[FacePart::Edge(k).number()] = of_edges[k];
            let adjacent = of_edges[k] + of_edges[(k + count - 1) % count];
            weights[FacePart::Node(k).number()] = self.fans[k].weight(adjacent, &is_joined);
        }
        weights
    }

    /// Returns true if a condition holds for an element with a common node.
    pub(in crate::contact) fn has_neighbour(&self, is_meant: impl Fn(usize) -> bool) -> bool {
        self.fans.iter().any(|fan| fan.elements.iter().any(|element| is_meant(*element)))
    }

    /// Returns the nodes with the coordinates renumbered for a term with the given coordinate list.
    pub(in crate::contact) fn nodes_within(&self, coordinates: &[usize]) -> FaceNodes {
        let local =
            |first: usize| coordinates.binary_search(&first).expect("the list contains all coordinates");
        self.nodes.iter().map(|(first, reference)| (local(*first), *reference)).collect()
    }

    /// Returns the number of the element in its shell.
    pub(in crate::contact) const fn number(&self) -> usize {
        self.number
    }
}

impl Fan {
    /// Finds the elements at a node of a mesh.
    fn new(node: usize, faces: &[Face], topology: &MeshTopology) -> Self {
        // Nodes before and after the node in an element.
        let around = |element: usize| {
            let own = faces[element].nodes();
            let k = own.iter().position(|n| *n == node)?;
            Some([own[(k + own.len() - 1) % own.len()], own[(k + 1) % own.len()]])
        };
        let across = |element: usize, side: usize| {
            let other = around(element)?[side];
            topology.of_edge([node, other]).find(|e| *e != element)
        };
        let at_node = topology.at_node(node);
        let first = at_node.iter().copied().find(|element| across(*element, 1).is_none());
        let is_closed = first.is_none();
        let mut elements: SmallVec<[usize; 6]> = SmallVec::new();
        let mut next = first.or_else(|| at_node.first().copied());
        while let Some(element) = next.filter(|element| !elements.contains(element)) {
            elements.push(element);
            next = across(element, 0);
        }
        Self { elements, is_closed }
    }

    /// Returns the share of one element in the weight of the node, given the sum of the weights of its edges at the node.
    ///
    /// The sum over the elements, their edges and the node is 1. If some elements are joined, it is 0 for each other element.
    fn weight(&self, adjacent: f64, is_joined: impl Fn(usize) -> bool) -> f64 {
        if self.elements.iter().any(|element| is_joined(*element)) {
            return -(1.0 + adjacent);
        }
        if self.is_closed { 1.0 / self.elements.len() as f64 } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fans(nodes: usize, faces: &[Face]) -> Vec<Fan> {
        let topology = MeshTopology::new(nodes, faces);
        (0..nodes).map(|node| Fan::new(node, faces, &topology)).collect()
    }

    /// Two by two quadrilaterals with nodes in rows of three.
    fn squares() -> Vec<Face> {
        [0, 1, 3, 4].map(|k| Face::Quad([k, k + 1, k + 4, k + 3])).to_vec()
    }

    #[test]
    fn fans_are_in_order_around_their_nodes() {
        let fans = fans(9, &squares());
        assert!(fans[4].is_closed && !fans[0].is_closed && !fans[1].is_closed);
        assert_eq!([0, 1, 4].map(|k| fans[k].elements.len()), [1, 2, 4]);
        let centre = &fans[4].elements;
        // Opposite elements are not neighbours.
        assert!((0..4).all(|k| centre[k] + centre[(k + 2) % 4] == 3), "{centre:?}");
    }

    /// The weights of all parts at a node have the sum 1, or 0 with joined elements among them.
    #[test]
    fn a_node_counts_once() {
        let faces = squares();
        for fan in fans(9, &faces) {
            for set in 0..16_usize {
                let is_joined = |element: usize| set >> element & 1 == 1;
                let count = fan.elements.len();
                let pairs = if fan.is_closed { count } else { count - 1 };
                let mut adjacent = vec![0.0; count];
                for k in 0..pairs {
                    let next = (k + 1) % count;
                    let weight = |other: usize| if is_joined(fan.elements[other]) { -1.0 } else { -0.5 };
                    adjacent[k] += weight(next);
                    adjacent[next] += weight(k);
                }
                let open: Vec<usize> = (0..count).filter(|k| !is_joined(fan.elements[*k])).collect();
                let of = |k: &usize| 1.0 + adjacent[*k] + fan.weight(adjacent[*k], is_joined);
                let sum: f64 = open.iter().map(of).sum();
                let expected = if open.len() == count { 1.0 } else { 0.0 };
                assert!((sum - expected).abs() < 1e-14, "{fan:?} {set:b}: {sum}");
            }
        }
    }
}
