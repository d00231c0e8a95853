//! Checks of the meshes of shear-deformable shells.

use ancf_mechanics::shells::TopologyDefect;

use super::fields;
use crate::errors::{Finding, finding, is_direction, no_direction, number, quoted};
use crate::model::{IndexedModel, Layup, MeshGroup, ShearShell, no_projection};

/// Cosine of the angle between a given director and the normal of an element at its node below which the director is rejected.
const TILTED: f64 = 0.7;

/// Checks mesh, groups, directors and axis of a shear-deformable shell.
pub(super) fn rules(
    model: &IndexedModel<'_>,
    path: &str,
    (shell, layup): (&ShearShell, Layup<'_>),
) -> Vec<Finding> {
    if let Some(error) = rule_of_source(path, shell) {
        return vec![error];
    }
    if let Some(k) = shell.mesh.nodes.iter().position(|node| node.iter().any(|x| !x.is_finite())) {
        return vec![finding(
            format!("{path}.mesh.nodes[{k}]"),
            "a coordinate that is not finite",
            "numbers",
        )];
    }
    if let Some(defect) = shell.defect() {
        return vec![defect_finding(path, shell, defect)];
    }
    let mut findings = rules_of_groups(path, shell);
    findings.extend(rule_of_directors(path, shell));
    if findings.is_empty() {
        findings.extend(rule_of_axis(model, path, (shell, layup)));
        findings.extend(fields::of_mesh(path, shell));
        findings.extend(rules_of_materials(model, path, (shell, layup)));
    }
    findings
}

/// Checks that the mesh has lists. Files are read with the model file.
fn rule_of_source(path: &str, shell: &ShearShell) -> Option<Finding> {
    if let Some(file) = &shell.mesh.file {
        let expected = "lists `nodes` and `elements`: files are read with a model file, to whose folder they are relative";
        return Some(finding(format!("{path}.mesh.file"), quoted(file), expected));
    }
    if shell.mesh.scale.is_some() {
        return Some(finding(format!("{path}.mesh.scale"), "a scale without a file", "no scale of lists"));
    }
    let key = if shell.mesh.nodes.is_empty() {
        "nodes"
    } else if shell.mesh.elements.is_empty() {
        "elements"
    } else {
        return None;
    };
    let expected = "a `file`, or lists `nodes` and `elements`";
    Some(Finding { absence: true, ..finding(format!("{path}.mesh"), format!("no {key}"), expected) })
}

/// Point of a node in a message.
fn defect_finding(path: &str, shell: &ShearShell, defect: TopologyDefect) -> Finding {
    let of_element = |k: usize| format!("{path}.mesh.elements[{k}]");
    match defect {
        TopologyDefect::NoSuchNode { element, node } => {
            let expected = format!("numbers of nodes from 0 to {}", shell.mesh.nodes.len().saturating_sub(1));
            finding(of_element(element), format!("node {node}"), expected)
                .rests_on([format!("{path}.mesh.nodes")])
        }
        TopologyDefect::RepeatedNode { element, node } => {
            let expected = "different nodes; a triangle has a list of three";
            finding(of_element(element), format!("node {node} a second time"), expected)
        }
        TopologyDefect::Degenerate { element, node } => {
            let found = format!("a collapsed or not convex corner at {}", shell.describe_node(node));
            let expected =
                "a convex element, with its nodes in order around it and angles between 3 and 177 degrees";
            finding(of_element(element), found, expected).rests_on([format!("{path}.mesh.nodes")])
        }
        TopologyDefect::Branch { nodes: [a, b], elements: [i, j, k] } => {
            let found = format!(
                "a third element at the edge from {} to {}, of elements {i} and {j}",
                shell.describe_node(a),
                shell.describe_node(b)
            );
            finding(of_element(k), found, "at most two elements at an edge: branches are not supported")
        }
        TopologyDefect::Orientation { elements: [i, k] } => {
            let found = format!("the nodes in the opposite order of those of element {i}");
            finding(of_element(k), found, "the normals of neighbouring elements on the same side")
        }
        TopologyDefect::Overlap { elements: [i, k] } => {
            finding(of_element(k), format!("the nodes of element {i}"), "each element once")
        }
        TopologyDefect::Disconnected { elements: [i, k], near } => {
            let near =
                near.map(|[a, b]| format!("; {} is near {}", shell.describe_node(a), shell.describe_node(b)));
            let found = format!(
                "an element that no sequence of neighbouring elements connects with element {i}{}",
                near.unwrap_or_default()
            );
            let expected = "one connected surface: parts share the nodes of their edges, and separate parts are bodies of their own";
            finding(of_element(k), found, expected)
        }
        TopologyDefect::Kink { elements: [i, k], angle } => {
            let found = format!("a kink of {} degrees to element {i}", number(angle.to_degrees().round()));
            let expected = format!(
                "an angle of at most {} rad, the value of `crease`, between the normals of neighbouring elements; \
                 a finer mesh of a curved surface, or a separate shell beyond a kink",
                number(shell.crease)
            );
            finding(of_element(k), found, expected).rests_on([format!("{path}.crease")])
        }
        _ => node_finding(path, shell, defect),
    }
}

/// Finding for a defect of a node.
fn node_finding(path: &str, shell: &ShearShell, defect: TopologyDefect) -> Finding {
    let [found, expected] = match defect {
        TopologyDefect::Unused { node } => [
            format!("{}, which no element has", shell.describe_node(node)),
            "nodes of elements only".to_owned(),
        ],
        TopologyDefect::Contact { node } => [
            format!("{}, at which parts of the mesh meet without a common edge", shell.describe_node(node)),
            "elements that are connected by edges".to_owned(),
        ],
        TopologyDefect::Coincident { nodes: [a, b] } => [
            format!("{}, the point of node {a}", shell.describe_node(b)),
            "one node at each point".to_owned(),
        ],
        TopologyDefect::Valence { node } => [
            format!("{} with more than 12 edges", shell.describe_node(node)),
            "at most 12 edges at a node".to_owned(),
        ],
        _ => [String::new(), "a mesh without defects".to_owned()],
    };
    let node = match defect {
        TopologyDefect::Unused { node }
        | TopologyDefect::Contact { node }
        | TopologyDefect::Valence { node }
        | TopologyDefect::Coincident { nodes: [_, node] } => node,
        _ => 0,
    };
    finding(format!("{path}.mesh.nodes[{node}]"), found, expected).rests_on([format!("{path}.mesh.elements")])
}

fn rules_of_groups(path: &str, shell: &ShearShell) -> Vec<Finding> {
    let topology = shell.topology();
    let rule = |(name, group): (&String, &MeshGroup)| {
        let key = format!("{path}.mesh.groups.{name}");
        let kinds = [group.nodes.is_empty(), group.edges.is_empty(), group.elements.is_empty()];
        if kinds.iter().filter(|is_empty| !**is_empty).count() != 1 {
            let expected = "one of `nodes`, `edges` and `elements` with at least one number";
            return Some(finding(key, "a group with none or several of them", expected));
        }
        let nodes = group.nodes.iter().chain(group.edges.iter().flatten());
        if let Some(node) = nodes.into_iter().find(|node| **node as usize >= shell.mesh.nodes.len()) {
            let expected = format!("numbers from 0 to {}", shell.mesh.nodes.len() - 1);
            return Some(finding(key, format!("node {node}"), expected));
        }
        if let Some(k) = group.elements.iter().find(|k| **k as usize >= shell.mesh.elements.len()) {
            let expected = format!("numbers from 0 to {}", shell.mesh.elements.len() - 1);
            return Some(finding(key, format!("element {k}"), expected));
        }
        let mut sorted = group.elements.clone();
        sorted.sort_unstable();
        if let Some(twice) = sorted.windows(2).find(|pair| pair[0] == pair[1]) {
            return Some(finding(key, format!("element {} a second time", twice[0]), "each element once"));
        }
        if group.edges.iter().any(|chain| chain.len() < 2) {
            return Some(finding(
                format!("{key}.edges"),
                "a chain of one node",
                "chains of at least two nodes",
            ));
        }
        let mut segments: Vec<[u32; 2]> =
            group.edges.iter().flat_map(|chain| chain.windows(2).map(|pair| [pair[0], pair[1]])).collect();
        if let Some([a, b]) =
            segments.iter().find(|[a, b]| topology.of_edge([*a as usize, *b as usize]).next().is_none())
        {
            let found = format!("nodes {a} and {b}, which have no common edge of an element");
            return Some(finding(format!("{key}.edges"), found, "chains of nodes along edges of elements"));
        }
        segments.iter_mut().for_each(|segment| segment.sort_unstable());
        segments.sort_unstable();
        segments.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| {
            let found = format!("the edge of nodes {} and {} a second time", pair[0][0], pair[0][1]);
            finding(format!("{key}.edges"), found, "each edge once")
        })
    };
    shell.mesh.groups.iter().filter_map(rule).collect()
}

fn rule_of_directors(path: &str, shell: &ShearShell) -> Option<Finding> {
    let (count, given) = (shell.mesh.nodes.len(), shell.mesh.directors.len());
    if given == 0 {
        return None;
    }
    if given != count {
        let (found, expected) =
            (format!("{given} directors"), format!("{count}, one for each node, or none"));
        return Some(finding(format!("{path}.mesh.directors"), found, expected));
    }
    if let Some(k) = shell.mesh.directors.iter().position(|director| !is_direction(*director)) {
        return Some(no_direction(format!("{path}.mesh.directors[{k}]"), shell.mesh.directors[k]));
    }
    let (points, directors) = (shell.points(), shell.unit_directors());
    for face in shell.faces() {
        for (&node, normal) in face.nodes().iter().zip(face.corner_normals(&points)) {
            if normal.dot(&directors[node]) < TILTED {
                let found =
                    format!("a direction far from the normal of an element at {}", shell.describe_node(node));
                let expected = "directions within 45 degrees of the normals, on the side from which elements are counter-clockwise";
                return Some(finding(format!("{path}.mesh.directors[{node}]"), found, expected));
            }
        }
    }
    None
}

/// Checks that the axis has a projection on the surface everywhere, and that orthotropic materials have one.
fn rule_of_axis(
    model: &IndexedModel<'_>,
    path: &str,
    (shell, layup): (&ShearShell, Layup<'_>),
) -> Option<Finding> {
    let key = format!("{path}.fibre_axis");
    let Some(axis) = &shell.fibre_axis else {
        let plies = layup.plies();
        let is_fibrous = |name: &str| model.materials.get(name).is_some_and(|m| m.orthotropic.is_some());
        return plies.iter().any(|(name, ..)| is_fibrous(name)).then(|| {
            let expected = "an axis: the mesh of an orthotropic shell has no direction of its own";
            Finding { absence: true, ..finding(key, "no axis", expected) }
        });
    };
    no_projection(key, axis.uniform()?, |axis| shell.normal_along(axis), format!("{path}.mesh.nodes"))
}

/// Checks that orthotropic materials have a transverse shear modulus.
fn rules_of_materials(
    model: &IndexedModel<'_>,
    path: &str,
    (shell, layup): (&ShearShell, Layup<'_>),
) -> Vec<Finding> {
    let mut names: Vec<&str> = layup.plies().into_iter().map(|(name, ..)| name).collect();
    names.sort_unstable();
    names.dedup();
    let rule = |name: &&str| {
        let orthotropic = model.materials.get(*name)?.orthotropic?;
        orthotropic.transverse_shear.is_none().then(|| {
            let found = format!("none, in a material of the shear-deformable shell {}", quoted(&shell.name));
            let expected = "the transverse shear modulus normal to the fibres";
            let key = format!("materials.{name}.orthotropic.transverse_shear");
            Finding { absence: true, ..finding(key, found, expected) }.rests_on([path.to_owned()])
        })
    };
    names.iter().filter_map(rule).collect()
}
