//! Findings about keys, and the keys on which each finding depends.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use crate::errors::{Finding, finding, number, quoted};
use crate::joints::End;
use crate::model::{
    At, Body, EdgePlace, ElementNodes, IndexedModel, NamedPosition, NodePlace, ON_AXIS, Place, PointPlace,
    ShearShell, bodies_of, edge_of_shell, joints_of, loads_of, named,
};
use crate::schema::unknown;

/// Largest distance of the ends of a joint, relative to the longer body.
pub(crate) const COINCIDENT: f64 = 1e-6;

/// Findings for names that are not unique, or unfit for columns.
pub(super) fn rule_of_names(names: Vec<(String, &str)>) -> Vec<Finding> {
    let unfit =
        |name: &str| name.trim() != name || name.contains(|c: char| c.is_control() || ",.'\"".contains(c));
    let spaced = names.iter().filter(|(_, name)| unfit(name)).map(|(path, name)| {
        finding(
            format!("{path}.name"),
            quoted(name),
            "a name without dot, comma, quotes or outer spaces, for use in columns",
        )
    });
    let mut first: HashMap<&str, &String> = HashMap::new();
    let twice = names.iter().filter_map(|(path, name)| {
        let first = match first.entry(name) {
            Entry::Vacant(place) => {
                place.insert(path);
                return None;
            }
            Entry::Occupied(first) => *first.get(),
        };
        let found = format!("{} a second time", quoted(name));
        let expected = format!("a name of its own; `{first}` has this one");
        Some(finding(format!("{path}.name"), found, expected).rests_on([format!("{first}.name")]))
    });
    spaced.chain(twice).collect()
}

/// Places of joints, loads and probes with their paths.
pub(crate) fn places_of<'m>(model: &'m IndexedModel<'_>) -> impl Iterator<Item = (String, &'m Place)> {
    let loads = loads_of(model).filter_map(|(path, load)| Some((format!("{path}.on"), load.on()?)));
    let probes = model.probes.iter().enumerate().map(|(i, probe)| (format!("probes[{i}].on"), &probe.on));
    let ends = joints_of(model).flat_map(|(path, joint)| {
        let (a, b) = joint.ends();
        let b = if let End::Place(b) = b { Some((format!("{path}.b"), b)) } else { None };
        [(format!("{path}.a"), a)].into_iter().chain(b)
    });
    ends.chain(loads).chain(probes)
}

pub(crate) fn rule_of_place(model: &IndexedModel<'_>, path: String, place: &Place) -> Option<Finding> {
    let Some((owner, body)) = body(model, place) else {
        return Some(unknown_body(model, format!("{path}.body"), &place.body));
    };
    let rests_on = |keys: [&str; 3]| {
        let keys = keys.map(|key| format!("{owner}.{key}"));
        keys.into_iter().chain([format!("{path}.body")]).collect::<Vec<_>>()
    };
    let name = quoted(body.name());
    match (body, &place.at) {
        (
            Body::Beam(_) | Body::Cable(_),
            At::Point(_) | At::Surface(_) | At::Edge(_) | At::Node(_) | At::NamedPoint(_),
        ) => {
            let expected =
                format!("\"start\", \"center\", \"end\" or an arc length of {name}, which is flexible");
            Some(finding(format!("{path}.at"), "a point", expected).rests_on(rests_on(["kind"; 3])))
        }
        (Body::Beam(_) | Body::Cable(_), at) => {
            let (s, length) = (body.arc_length(at), body.length());
            let beyond = length > 0.0 && s > length * (1.0 + ON_AXIS);
            beyond.then(|| {
                let expected = format!("at most {}, the length of {name}", number(length));
                finding(format!("{path}.at"), number(s), expected).rests_on(rests_on(["from", "to", "shape"]))
            })
        }
        (Body::Shell(_), At::Edge(EdgePlace { edge })) => {
            edge_of_shell(format!("{path}.at.edge"), edge, Some((owner.clone(), body)))
        }
        (Body::ShearShell(shell), at) => rule_of_mesh_place(path, shell, at, owner.clone()),
        (Body::Shell(_), At::Surface(at)) => at.iter().any(|x| !(0.0..=1.0).contains(x)).then(|| {
            let found = format!("[{}, {}]", number(at[0]), number(at[1]));
            finding(format!("{path}.at"), found, "u and v from 0 to 1")
        }),
        (Body::Rigid(_), At::Point(_)) | (_, At::Named(NamedPosition::Center)) => None,
        (_, at) => {
            let found = match at {
                At::Named(NamedPosition::Start) => "\"start\"".into(),
                At::Named(_) => "\"end\"".into(),
                At::Length(s) => number(*s),
                At::Point(_) => "a point".into(),
                At::Surface(_) => "a point [u, v] of a shell".into(),
                At::Edge(_) => "an edge of a shell".into(),
                At::Node(_) | At::NamedPoint(_) => "a node of a mesh".into(),
            };
            let expected = match body {
                Body::Shell(_) => format!("\"center\", a point [u, v] or an edge: {name} is a shell"),
                Body::Mass(_) => format!("\"center\": {name} is a point mass"),
                _ => format!("\"center\" or a point [x, y, z]: {name} is rigid"),
            };
            Some(finding(format!("{path}.at"), found, expected).rests_on(rests_on(["kind"; 3])))
        }
    }
}

/// Checks a place on the mesh of a shear-deformable shell. Meshes with defects have findings of their own.
fn rule_of_mesh_place(path: String, shell: &ShearShell, at: &At, owner: String) -> Option<Finding> {
    let key = format!("{path}.at");
    let nodes = shell.mesh.nodes.len() as u32;
    if shell.mesh.elements.iter().flat_map(ElementNodes::nodes).any(|node| *node >= nodes) {
        return None;
    }
    let error = match at {
        At::Edge(EdgePlace { edge }) if shell.edge(edge).is_none() => {
            let names = shell.mesh.groups.iter().filter(|(_, group)| !group.edges.is_empty());
            let expected = named("edges", names.map(|(name, _)| name.as_str()));
            finding(format!("{key}.edge"), quoted(edge.name()), expected)
        }
        At::Node(NodePlace { node }) if *node >= nodes => {
            let expected =
                format!("a node of {}, from 0 to {}", quoted(&shell.name), nodes.saturating_sub(1));
            finding(format!("{key}.node"), format!("{node}"), expected)
        }
        At::NamedPoint(PointPlace { point }) if shell.node(at).is_none() => {
            let names = shell.mesh.groups.iter().filter(|(_, group)| group.nodes.len() == 1);
            let expected = named("one node", names.map(|(name, _)| name.as_str()));
            finding(format!("{key}.point"), quoted(point), expected)
        }
        At::Point(point) if shell.place(at).is_none() => {
            let found = format!("[{}]", point.map(number).join(", "));
            let expected = shell.nearest(point).map_or_else(
                || "a point of the middle surface".to_owned(),
                |nearest| {
                    let [x, y, z] = <[f64; 3]>::from(shell.point_at(nearest.place)).map(number);
                    format!("a point of the middle surface, whose nearest point is [{x}, {y}, {z}]")
                },
            );
            finding(key, found, expected)
        }
        At::Edge(_) | At::Node(_) | At::NamedPoint(_) | At::Point(_) => return None,
        At::Named(_) | At::Length(_) | At::Surface(_) => {
            let expected = format!(
                "a point [x, y, z], {{ node = N }}, {{ point = \"NAME\" }} or {{ edge = \"NAME\" }}: {} is a shell with a mesh",
                quoted(&shell.name)
            );
            finding(key, "a position of another kind of body", expected)
        }
    };
    Some(error.rests_on([owner]))
}

/// Body of a place, with its path.
pub(crate) fn body<'m>(model: &IndexedModel<'m>, place: &Place) -> Option<(String, &'m Body)> {
    model.named(&place.body)
}

/// Finding for an unknown body.
pub(crate) fn unknown_body(model: &IndexedModel<'_>, path: String, name: &str) -> Finding {
    let names = model.bodies.iter().map(Body::name).collect();
    unknown(path, "body", name, names).rests_on(bodies_of(model).map(|(path, _)| format!("{path}.name")))
}
