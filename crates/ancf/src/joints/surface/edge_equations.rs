//! Equations of the supports of shells: linear equations of nodal vectors, and on rigid bodies angles of slopes and normals.

use ancf_mechanics::constraints::ConstrainedVector;
use ancf_mechanics::kinematics::{Attachment, BodyVector, Marker};
use ancf_mechanics::shells::{ShellEdge, ShellMesh};
use nalgebra::Vector3;

use super::condition::{SupportCondition, SupportedAxis};
use crate::joints::parts::JointBuilder;
use crate::model::At;

/// Rate of a direction below which it counts as constant.
const CONSTANT: f64 = 1e-9;
/// Distance of the points between which the normal is differentiated, in elements.
const STEP: f64 = 1e-4;

/// Vectors of a node: r, the derivatives along and across the edge, and the mixed one.
const POSITION: usize = 0;
const MIXED: usize = 3;

/// Adds the equations of a support.
pub(super) fn add_equations(
    builder: &mut JointBuilder<'_>,
    at: &At,
    condition: SupportCondition,
    guides: &[SupportedAxis],
) {
    let Some(mesh) = builder.shell() else { return };
    if let (Some(base), At::Edge(place)) = (builder.base(), at) {
        return add_to_body(builder, (mesh, place.edge.edge()), base, condition);
    }
    let global = [Vector3::x(), Vector3::y(), Vector3::z()];
    let axes: Vec<Vector3<f64>> = match condition {
        SupportCondition::Guided => guides.iter().map(|axis| global[number(*axis)]).collect(),
        _ => global.to_vec(),
    };
    let mut add = |parts: &[(usize, usize, Vector3<f64>)], name: &'static str| {
        let vectors = parts.iter().map(|&(node, kind, direction)| {
            let (first, reference) = mesh.nodal(node, kind);
            ConstrainedVector { first, reference, direction, is_position: kind == POSITION }
        });
        builder.add_linear(vectors.collect(), Vec::new(), name);
    };
    let At::Edge(place) = at else {
        let node = mesh.node_at(at.on_surface().expect("checked places are edges or points of the shell"));
        axes.iter().for_each(|&axis| add(&[(node, POSITION, axis)], "position"));
        return;
    };
    let edge = place.edge.edge();
    let [along, across] = if edge.along_v { [2, 1] } else { [1, 2] };
    for (k, node) in mesh.edge_nodes(edge).into_iter().enumerate() {
        if condition == SupportCondition::Symmetry {
            let normal = mesh.nodal(node, across).1.normalize();
            add(&[(node, POSITION, normal)], "position");
            add(&[(node, along, normal)], "position along the edge");
            for axis in ancf_mechanics::bodies::normals_to(normal) {
                add(&[(node, across, axis)], "slope across the edge");
                add(&[(node, MIXED, axis)], "slope along the edge");
            }
            continue;
        }
        for &axis in &axes {
            add(&[(node, POSITION, axis)], "position");
            add(&[(node, along, axis)], "position along the edge");
        }
        if condition == SupportCondition::Clamped {
            let (normal, rate) = normal_of(mesh, edge, k);
            add(&[(node, across, normal)], "slope across the edge");
            add(&[(node, MIXED, normal), (node, across, rate)], "slope along the edge");
        }
    }
}

/// Adds the equations of an edge that moves with a rigid body.
fn add_to_body(
    builder: &mut JointBuilder<'_>,
    (mesh, edge): (&ShellMesh, ShellEdge),
    base: &Attachment,
    condition: SupportCondition,
) {
    let [along, across] = if edge.along_v { [2, 1] } else { [1, 2] };
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    let directions = axes.map(|axis| base.direction(axis));
    for (i, j) in (0..3).flat_map(|i| (0..=i).map(move |j| (i, j))) {
        builder.assume_constant(&directions[i], &directions[j]);
    }
    for (k, node) in mesh.edge_nodes(edge).into_iter().enumerate() {
        for (kind, name) in [(POSITION, "position"), (along, "position along the edge")] {
            let (first, reference) = mesh.nodal(node, kind);
            let point = base.point.linear();
            let moved = match kind {
                POSITION => {
                    let arm = base.material_direction(reference - point.reference());
                    Marker::combined([(1.0, point), (1.0, &arm)])
                }
                _ => base.material_direction(reference),
            };
            for axis in axes {
                let vector = |first, direction| ConstrainedVector {
                    first,
                    reference,
                    direction,
                    is_position: kind == POSITION,
                };
                let others = moved.parts().iter().map(|&(first, weight)| vector(first, axis * -weight));
                builder.add_linear(vec![vector(first, axis)], others.collect(), name);
            }
        }
        if condition == SupportCondition::Clamped {
            let (normal, rate) = normal_of(mesh, edge, k);
            let [normal, rate] = [normal, rate].map(|direction| base.direction(direction));
            let slope = |kind: usize| {
                let (first, reference) = mesh.nodal(node, kind);
                BodyVector::from(Marker::new([(first, 1.0)], reference))
            };
            let (slope, mixed) = (slope(across), slope(MIXED));
            builder.keep_edge_angles(&[(&slope, &normal)], "slope across the edge");
            builder.keep_edge_angles(&[(&mixed, &normal), (&slope, &rate)], "slope along the edge");
        }
    }
}

const fn number(axis: SupportedAxis) -> usize {
    match axis {
        SupportedAxis::X => 0,
        SupportedAxis::Y => 1,
        SupportedAxis::Z => 2,
    }
}

/// Unit normal of the reference surface at the k-th node of an edge, and its derivative along the edge by ξ or η.
fn normal_of(mesh: &ShellMesh, edge: ShellEdge, k: usize) -> (Vector3<f64>, Vector3<f64>) {
    let count = mesh.divisions()[usize::from(edge.along_v)] as f64;
    let [u, v] = ShellMesh::edge_middle(edge);
    let normal = |t: f64| {
        let at = if edge.along_v { [u, t / count] } else { [t / count, v] };
        let [a, b] = [[1, 0], [0, 1]].map(|order| mesh.derivative(at, order).reference());
        a.cross(&b).normalize()
    };
    let k = k as f64;
    let [low, high] = [(k - STEP).max(0.0), (k + STEP).min(count)];
    let rate = (normal(high) - normal(low)) / (high - low);
    (normal(k), if rate.norm() < CONSTANT { Vector3::zeros() } else { rate })
}
