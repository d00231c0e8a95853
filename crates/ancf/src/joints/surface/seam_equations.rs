//! Equations of seams: linear equations of the nodal vectors of two edges, and angles of the normals along them.

use ancf_mechanics::constraints::ConstrainedVector;
use ancf_mechanics::kinematics::BodyVector;
use ancf_mechanics::shells::{ShellEdge, ShellMesh};
use nalgebra::Vector3;

use super::condition::SeamCondition;
use crate::joints::parts::JointBuilder;

/// Vectors of a node that are the point and the derivatives along an edge.
const POSITION: usize = 0;

/// Edge of a mesh with its nodes in the order of the seam.
struct SeamEdge<'a> {
    mesh: &'a ShellMesh,
    edge: ShellEdge,
    nodes: Vec<usize>,
    /// −1 for an edge in the direction opposite to that of the seam.
    sense: f64,
}

impl<'a> SeamEdge<'a> {
    fn new(mesh: &'a ShellMesh, edge: ShellEdge, is_reversed: bool) -> Self {
        let mut nodes = mesh.edge_nodes(edge);
        if is_reversed {
            nodes.reverse();
        }
        Self { mesh, edge, nodes, sense: if is_reversed { -1.0 } else { 1.0 } }
    }

    /// Vector of a node along a direction: its position, or its derivative along the seam.
    fn vector(&self, k: usize, of_slope: bool, direction: Vector3<f64>) -> ConstrainedVector {
        let (kind, factor) = match (of_slope, self.edge.along_v) {
            (false, _) => (POSITION, 1.0),
            (true, true) => (2, self.sense),
            (true, false) => (1, self.sense),
        };
        let (first, reference) = self.mesh.nodal(self.nodes[k], kind);
        ConstrainedVector { first, reference, direction: direction * factor, is_position: kind == POSITION }
    }

    /// Sum of the distances of corresponding nodes.
    fn distance(&self, other: &Self) -> f64 {
        let point = |edge: &Self, k: usize| edge.mesh.nodal(edge.nodes[k], POSITION).1;
        (0..self.nodes.len()).map(|k| (point(self, k) - point(other, k)).norm()).sum()
    }

    /// Place at a fraction of the seam.
    fn at(&self, part: f64) -> [f64; 2] {
        let t = if self.sense > 0.0 { part } else { 1.0 - part };
        let [u, v] = ShellMesh::edge_middle(self.edge);
        if self.edge.along_v { [u, t] } else { [t, v] }
    }

    /// Normal in the reference state at a fraction of the seam, and the direction of the seam.
    fn directions(&self, part: f64) -> [Vector3<f64>; 2] {
        let [a, b] = [[1, 0], [0, 1]].map(|order| self.mesh.derivative(self.at(part), order).reference());
        [a.cross(&b).normalize(), if self.edge.along_v { b } else { a }.normalize()]
    }

    /// Direction that rotates with the surface at a fraction of the seam.
    fn rotating(&self, part: f64, direction: Vector3<f64>) -> BodyVector {
        BodyVector::turned(&self.mesh.frame(self.at(part)), direction)
    }
}

/// Adds the equations of a seam. Both edges have the same number of elements.
pub(super) fn add_equations(builder: &mut JointBuilder<'_>, edges: [ShellEdge; 2], condition: SeamCondition) {
    let (Some(a), Some(b)) = (builder.shell(), builder.other_shell()) else { return };
    let a = SeamEdge::new(a, edges[0], false);
    let [same, reversed] = [false, true].map(|is_reversed| SeamEdge::new(b, edges[1], is_reversed));
    let b = if a.distance(&reversed) < a.distance(&same) { reversed } else { same };
    let global = [Vector3::x(), Vector3::y(), Vector3::z()];
    for k in 0..a.nodes.len() {
        for of_slope in [false, true] {
            let name = if of_slope { "position along the seam" } else { "position" };
            for axis in global {
                let [own, other] = [a.vector(k, of_slope, axis), b.vector(k, of_slope, -axis)];
                builder.add_linear(vec![own], vec![other], name);
            }
        }
    }
    if condition == SeamCondition::Hinged {
        return;
    }
    // The slopes across the edges are cubic along each element. The angle is constrained at its ends and in its middle.
    let count = 2 * (a.nodes.len() - 1);
    for k in 0..=count {
        let part = k as f64 / count as f64;
        let [normal, along] = a.directions(part);
        let level = a.rotating(part, normal);
        let beside = b.rotating(part, normal.cross(&along));
        builder.keep_edge_angles(&[(&level, &beside)], "angle of the seam");
    }
}
