//! Seams of shear-deformable shells: equal positions, and directors that are equal or keep their angle.

use ancf_mechanics::kinematics::{BodyVector, Marker};
use ancf_mechanics::shells::ShearShellMesh;
use nalgebra::Vector3;

use super::condition::SeamCondition;
use super::mesh_equations::{DIRECTOR, POSITION, vector};
use crate::errors::{Finding, finding, number};
use crate::joints::parts::JointBuilder;
use crate::model::{EdgeName, ShearShell};

/// Largest distance of corresponding nodes, relative to the longest segment of the edge.
const APART: f64 = 1e-6;
/// Largest angle of directors that count as equal.
const EQUAL: f64 = 1e-3;
/// Smallest angle of directors, and of a director and the opposite of the other, that determines the angle of a kink.
const KINK: f64 = 0.2;

/// Pairs of corresponding nodes of two edges.
///
/// # Errors
/// The reason why the edges have no common nodes.
fn pairs([(a, edge), (b, other)]: [(&ShearShell, &EdgeName); 2]) -> Result<Vec<[usize; 2]>, String> {
    let [first, second] = [a.edge_nodes(edge), b.edge_nodes(other)];
    if first.len() != second.len() {
        return Err(format!("edges of {} and {} nodes", first.len(), second.len()));
    }
    let (own, points) = (a.points(), b.points());
    let lengths = a.edge_segments(edge).into_iter().map(|[i, j]| (own[i] - own[j]).norm());
    let size = lengths.fold(0.0, f64::max);
    let pair = |node: usize| {
        let distance = |&k: &usize| (points[k] - own[node]).norm();
        let nearest = second.iter().copied().min_by(|i, j| distance(i).total_cmp(&distance(j)));
        let nearest = nearest.expect("an edge has nodes");
        let apart = distance(&nearest) / size;
        if apart <= APART {
            return Ok([node, nearest]);
        }
        let text = format!("{}, {} of an element from the other edge", a.describe_node(node), number(apart));
        Err(text)
    };
    first.into_iter().map(pair).collect()
}

/// Finding for edges without common nodes, or with an angle that their directors do not determine. `path` is that of the joint.
pub(super) fn check(
    path: &str,
    edges: [(&ShearShell, &EdgeName); 2],
    condition: SeamCondition,
) -> Option<Finding> {
    let pairs = match pairs(edges) {
        Ok(pairs) => pairs,
        Err(found) => {
            let error = finding(path.to_owned(), found, "edges with the same nodes");
            return Some(error.rests_on(["bodies".into()]));
        }
    };
    if condition == SeamCondition::Hinged {
        return None;
    }
    let [(a, _), (b, _)] = edges;
    let (own, others) = (a.unit_directors(), b.unit_directors());
    let angle = |&[i, j]: &[usize; 2]| own[i].angle(&others[j]);
    let is_unfit = |pair: &[usize; 2]| {
        let angle = angle(pair);
        angle > EQUAL && !(KINK..=std::f64::consts::PI - KINK).contains(&angle)
    };
    let unfit = pairs.iter().find(|pair| is_unfit(pair))?;
    let found = format!("directors at {} radians at {}", number(angle(unfit)), a.describe_node(unfit[0]));
    let expected = format!(
        "equal directors, such as those of `mesh.directors`, or a kink between {} and {}; neighbours with smaller kinks may be one mesh",
        number(KINK),
        number(std::f64::consts::PI - KINK)
    );
    Some(finding(path.to_owned(), found, expected).rests_on(["bodies".into()]))
}

/// Adds the equations of a seam of two meshes.
///
/// The directors of a kink keep their product: two directors of constant angle rotate about the seam together. Their rotations along the
/// seam follow from its displacements and the transverse shear stiffness.
pub(super) fn add_equations(builder: &mut JointBuilder<'_>, edges: [&EdgeName; 2], condition: SeamCondition) {
    let (Some((mesh, a)), Some((other, b))) = (builder.shear_shell(), builder.other_shear_shell()) else {
        return;
    };
    for [own, second] in pairs([(a, edges[0]), (b, edges[1])]).expect("checked seams have common nodes") {
        equate(builder, [(mesh, own), (other, second)], POSITION, "position");
        if condition == SeamCondition::Hinged {
            continue;
        }
        let vectors = [(mesh, own), (other, second)].map(|(mesh, node)| mesh.nodal(node, DIRECTOR));
        if vectors[0].1.angle(&vectors[1].1) <= EQUAL {
            equate(builder, [(mesh, own), (other, second)], DIRECTOR, "director");
            continue;
        }
        let [d, e] = vectors.map(|(first, director)| BodyVector::from(Marker::new([(first, 1.0)], director)));
        builder.keep_edge_angles(&[(&d, &e)], "angle of the seam");
    }
}

/// Equates the displacements of the positions or of the directors of two nodes.
fn equate(
    builder: &mut JointBuilder<'_>,
    nodes: [(&ShearShellMesh, usize); 2],
    kind: usize,
    name: &'static str,
) {
    for axis in [Vector3::x(), Vector3::y(), Vector3::z()] {
        let [own, other] = [(nodes[0], axis), (nodes[1], -axis)]
            .map(|((mesh, node), direction)| vector(mesh, node, kind, direction));
        builder.add_linear(vec![own], vec![other], name);
    }
}
