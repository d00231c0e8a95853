use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::condition::SeamCondition;
use super::mesh_seam;
use super::seam_equations::add_equations;
use crate::errors::{Finding, finding, number, quoted};
use crate::joints::parts::{End, JointBuilder, JointContext, JointKind};
use crate::model::{At, Body, EdgeName, Place, Shell};
use crate::units::Scaled;

/// Largest difference of corresponding nodes of both edges, relative to the length of an element.
const APART: f64 = 1e-6;

/// Seam of two edges of shells, or of two edges of one shell such as a closed cylinder.
///
/// Both edges have the same points and the same number of elements. Both shells are thin, or both are shear-deformable.
///
/// Several seams may join an edge, such as those of a rib.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Seam {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// Edge of a shell, on which the reaction acts. Its moments refer to the middle of the edge.
    pub a: Place,
    /// Edge of another shell, or another edge of the same one.
    pub b: End,
    /// Rotations about the seam.
    #[serde(default)]
    pub condition: SeamCondition,
}

impl Seam {
    /// Edge of an end.
    fn edges(&self) -> Option<[(&Place, &EdgeName); 2]> {
        let End::Place(b) = &self.b else { return None };
        Some([(&self.a, edge(&self.a)?), (b, edge(b)?)])
    }
}

/// Edge of a place.
const fn edge(place: &Place) -> Option<&EdgeName> {
    if let At::Edge(place) = &place.at { Some(&place.edge) } else { None }
}

/// Number of elements along an edge.
fn divisions(shell: &Shell, edge: &EdgeName) -> u32 {
    shell.elements[usize::from(edge.edge().along_v)]
}

/// Points and tangents of an edge at its nodes, the tangents per element.
fn nodes(shell: &Shell, edge: &EdgeName) -> Vec<[Vector3<f64>; 2]> {
    let (count, edge, geometry) = (divisions(shell, edge), edge.edge(), shell.geometry());
    let fixed = if edge.at_end { 1.0 } else { 0.0 };
    let node = |k: u32| {
        let t = f64::from(k) / f64::from(count);
        let [r, of_u, of_v, _] = geometry.map(if edge.along_v { [fixed, t] } else { [t, fixed] });
        [geometry.origin() + r, if edge.along_v { of_v } else { of_u } / f64::from(count)]
    };
    (0..=count).map(node).collect()
}

/// Largest differences of the nodes of two edges and of their tangents, relative to the length of an element. The second edge has
/// either direction.
fn difference([(a, edge), (b, other)]: [(&Shell, &EdgeName); 2]) -> f64 {
    let [first, second] = [nodes(a, edge), nodes(b, other)];
    let element = first.iter().map(|[_, tangent]| tangent.norm()).fold(0.0, f64::max);
    let far = |[[r, t], [s, w]]: [[Vector3<f64>; 2]; 2]| (r - s).norm().max((t - w).norm());
    let of = |second: &mut dyn Iterator<Item = [Vector3<f64>; 2]>| {
        first.iter().zip(second).map(|(own, other)| far([*own, other])).fold(0.0, f64::max)
    };
    let same = of(&mut second.iter().copied());
    let reversed = of(&mut second.iter().rev().map(|[r, t]| [*r, -t]));
    same.min(reversed) / element
}

impl JointKind for Seam {
    fn word(&self) -> &'static str {
        "seam"
    }

    fn name(&self) -> &str {
        &self.name
    }

    fn ends(&self) -> (&Place, &End) {
        (&self.a, &self.b)
    }

    fn removes(&self) -> usize {
        match self.condition {
            SeamCondition::Rigid => 6,
            SeamCondition::Hinged => 5,
        }
    }

    fn build(&self, builder: &mut JointBuilder<'_>) {
        let Some([(_, a), (_, b)]) = self.edges() else { return };
        if builder.shear_shell().is_some() {
            return mesh_seam::add_equations(builder, [a, b], self.condition);
        }
        add_equations(builder, [a.edge(), b.edge()], self.condition);
    }

    fn is_distributed(&self) -> bool {
        true
    }

    fn check(&self, path: &str, context: &dyn JointContext) -> Vec<Finding> {
        let Some(edges) = self.edges() else {
            let expected = "edges of shells at both ends, such as { edge = \"u_start\" }";
            return vec![finding(path.to_owned(), "a seam without two edges", expected)];
        };
        let mut findings = Vec::new();
        for (end, (place, _)) in ["a", "b"].into_iter().zip(edges) {
            if place.offset != [0.0; 3] {
                findings.push(finding(format!("{path}.{end}.offset"), "an arm", "no arm: edges are joined"));
            }
            if let Some(body) = context.body(place)
                && !body.is_shell()
            {
                let found = format!("{}, which is no shell", quoted(body.name()));
                findings.push(
                    finding(format!("{path}.{end}.body"), found, "a shell").rests_on(["bodies".into()]),
                );
            }
        }
        let [(a, edge), (b, other)] = edges;
        let (Some(first), Some(second)) = (context.body(a), context.body(b)) else { return findings };
        if first.is_shell() && a.body == b.body && edge == other {
            findings.push(finding(format!("{path}.b.at"), "the same edge", "another edge"));
            return findings;
        }
        match (first, second) {
            (Body::Shell(first), Body::Shell(second)) => {
                findings.extend(check_thin(path, [(first, edge), (second, other)]));
            }
            (Body::ShearShell(first), Body::ShearShell(second)) => {
                let exist = first.edge(edge).is_some() && second.edge(other).is_some();
                if exist && first.defect().is_none() && second.defect().is_none() {
                    let edges = [(first, edge), (second, other)];
                    findings.extend(mesh_seam::check(path, edges, self.condition));
                }
            }
            (Body::Shell(_), Body::ShearShell(_)) | (Body::ShearShell(_), Body::Shell(_)) => {
                let expected = "two thin or two shear-deformable shells";
                let error = finding(path.to_owned(), "edges of shells of both kinds", expected);
                findings.push(error.rests_on(["bodies".into()]));
            }
            _ => {}
        }
        findings
    }
}

/// Finding for edges of thin shells with different nodes.
fn check_thin(path: &str, [(first, edge), (second, other)]: [(&Shell, &EdgeName); 2]) -> Option<Finding> {
    if [edge, other].into_iter().any(|edge| matches!(edge, EdgeName::Named(_))) {
        return None;
    }
    let [n, m] = [divisions(first, edge), divisions(second, other)];
    if n != m {
        let found = format!("edges of {n} and {m} elements");
        let expected = "edges with the same number of elements";
        return Some(finding(path.to_owned(), found, expected).rests_on(["bodies".into()]));
    }
    let apart = difference([(first, edge), (second, other)]);
    apart.partial_cmp(&APART).is_none_or(std::cmp::Ordering::is_gt).then(|| {
        let found = format!("edges whose nodes or tangents differ by {} of an element", number(apart));
        let expected = "edges with the same nodes and the same curve between them";
        finding(path.to_owned(), found, expected).rests_on(["bodies".into()])
    })
}
