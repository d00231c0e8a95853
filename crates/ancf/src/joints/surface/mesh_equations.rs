//! Equations of the supports of shear-deformable shells: linear equations of positions and directors, and on rigid bodies angles of
//! directors.

use ancf_mechanics::bodies::normals_to;
use ancf_mechanics::constraints::ConstrainedVector;
use ancf_mechanics::kinematics::{Attachment, BodyVector, Marker};
use ancf_mechanics::shells::ShearShellMesh;
use nalgebra::Vector3;

use super::condition::{SupportCondition, SupportedAxis};
use crate::joints::parts::JointBuilder;
use crate::model::{At, EdgeName, EdgePlace, ShearShell};

/// Statement of a support.
#[derive(Clone, Copy, Debug)]
pub(super) struct MeshSupport<'a> {
    /// Edge or node.
    pub(super) at: &'a At,
    pub(super) condition: SupportCondition,
    /// Global axes of a guided support.
    pub(super) axes: &'a [SupportedAxis],
    /// True if directors do not rotate along the edge.
    pub(super) hard: bool,
}

/// Kinds of the vectors of a node.
pub(super) const POSITION: usize = 0;
pub(super) const DIRECTOR: usize = 1;

/// Vector of a node along a direction: its position or its director.
pub(super) fn vector(
    mesh: &ShearShellMesh,
    node: usize,
    kind: usize,
    direction: Vector3<f64>,
) -> ConstrainedVector {
    let (first, reference) = mesh.nodal(node, kind);
    ConstrainedVector { first, reference, direction, is_position: kind == POSITION }
}

/// Nodes of a support with the directions of the edge there; none at a single node.
fn nodes(shell: &ShearShell, at: &At) -> Vec<(usize, Option<Vector3<f64>>)> {
    let At::Edge(EdgePlace { edge }) = at else {
        return shell.node(at).map(|node| (node, None)).into_iter().collect();
    };
    shell.edge_nodes(edge).into_iter().map(|node| (node, edge_direction(shell, edge, node))).collect()
}

/// Direction of an edge at a node: the mean of its element edges there.
fn edge_direction(shell: &ShearShell, edge: &EdgeName, node: usize) -> Option<Vector3<f64>> {
    let points = |k: usize| Vector3::from(shell.mesh.nodes[k]);
    let own = shell.edge_segments(edge).into_iter().filter(|segment| segment.contains(&node));
    let sum: Vector3<f64> = own.map(|[a, b]| (points(b) - points(a)).normalize()).sum();
    sum.try_normalize(1e-9)
}

/// Adds the equations of a support of a shear-deformable shell.
pub(super) fn add_equations(builder: &mut JointBuilder<'_>, support: MeshSupport<'_>) {
    let Some((mesh, shell)) = builder.shear_shell() else { return };
    let nodes = nodes(shell, support.at);
    if let Some(base) = builder.base() {
        return add_to_body(builder, mesh, &nodes, base, support);
    }
    let plane = shell.plane_of(support.at);
    for (node, along) in nodes {
        let mut add = |kind: usize, direction: Vector3<f64>, name: &'static str| {
            builder.add_linear(vec![vector(mesh, node, kind, direction)], Vec::new(), name);
        };
        if support.condition == SupportCondition::Symmetry {
            let Some(normal) = plane else { continue };
            add(POSITION, normal, "position");
            add(DIRECTOR, normal, "director");
            continue;
        }
        for axis in positions(support) {
            add(POSITION, axis, "position");
        }
        let director = mesh.nodal(node, DIRECTOR).1;
        if support.condition == SupportCondition::Clamped {
            normals_to(director).into_iter().for_each(|axis| add(DIRECTOR, axis, "director"));
        } else if let Some(along) = along.filter(|_| support.hard) {
            add(DIRECTOR, (along - director * director.dot(&along)).normalize(), "director along the edge");
        }
    }
}

/// Directions in which positions are constrained.
fn positions(support: MeshSupport<'_>) -> Vec<Vector3<f64>> {
    let axis = |axis: &SupportedAxis| match axis {
        SupportedAxis::X => Vector3::x(),
        SupportedAxis::Y => Vector3::y(),
        SupportedAxis::Z => Vector3::z(),
    };
    match support.condition {
        SupportCondition::Guided => support.axes.iter().map(axis).collect(),
        _ => vec![Vector3::x(), Vector3::y(), Vector3::z()],
    }
}

/// Adds the equations of nodes that move with a rigid body.
fn add_to_body(
    builder: &mut JointBuilder<'_>,
    mesh: &ShearShellMesh,
    nodes: &[(usize, Option<Vector3<f64>>)],
    base: &Attachment,
    support: MeshSupport<'_>,
) {
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    let directions = axes.map(|axis| base.direction(axis));
    for (i, j) in (0..3).flat_map(|i| (0..=i).map(move |j| (i, j))) {
        builder.assume_constant(&directions[i], &directions[j]);
    }
    for &(node, along) in nodes {
        let (first, reference) = mesh.nodal(node, POSITION);
        let point = base.point.linear();
        let arm = base.material_direction(reference - point.reference());
        let moved = Marker::combined([(1.0, point), (1.0, &arm)]);
        for axis in axes {
            let vector =
                |first, direction| ConstrainedVector { first, reference, direction, is_position: true };
            let others = moved.parts().iter().map(|&(first, weight)| vector(first, axis * -weight));
            builder.add_linear(vec![vector(first, axis)], others.collect(), "position");
        }
        let (first, director) = mesh.nodal(node, DIRECTOR);
        let own = BodyVector::from(Marker::new([(first, 1.0)], director));
        let normals: Vec<Vector3<f64>> = match (support.condition, along) {
            (SupportCondition::Clamped, _) => normals_to(director).into_iter().collect(),
            (_, Some(along)) if support.hard => vec![(along - director * director.dot(&along)).normalize()],
            _ => Vec::new(),
        };
        for normal in normals {
            builder.keep_edge_angles(&[(&own, &base.direction(normal))], "director");
        }
    }
}
