use super::body::Body;
use super::parts::EdgeName;
use crate::errors::{Finding, finding, is_direction, listed, no_direction, quoted};

/// Finding for a load of a shell on a body that is no shell. `body` is the body with its path.
pub(crate) fn shell_body(path: &str, body: Option<(String, &Body)>) -> Option<Finding> {
    let (owner, body) = body?;
    let found = format!("{}, which is no shell", quoted(body.name()));
    (!body.is_shell()).then(|| finding(format!("{path}.body"), found, "a shell").rests_on([owner]))
}

/// Finding for an edge that a shell does not have. `key` is the path of the edge.
pub(crate) fn edge_of_shell(key: String, edge: &EdgeName, body: Option<(String, &Body)>) -> Option<Finding> {
    let (owner, body) = body?;
    let found = quoted(edge.name());
    let error = match (body, edge) {
        (Body::Shell(_), EdgeName::Named(_)) => {
            finding(key, found, "\"u_start\", \"u_end\", \"v_start\" or \"v_end\": an edge of a thin shell")
        }
        (Body::ShearShell(shell), _) if shell.edge(edge).is_none() => {
            let names = shell.mesh.groups.iter().filter(|(_, group)| !group.edges.is_empty());
            let expected = named("edges", names.map(|(name, _)| name.as_str()));
            finding(key, found, expected)
        }
        _ => return None,
    };
    Some(error.rests_on([owner]))
}

/// Finding for a region that a shell does not have.
pub(crate) fn region_of_shell(
    path: &str,
    region: Option<&str>,
    body: Option<(String, &Body)>,
) -> Option<Finding> {
    let ((owner, body), name) = (body?, region?);
    let (key, found) = (format!("{path}.region"), quoted(name));
    let Body::ShearShell(shell) = body else {
        let expected = "no key `region`: only shear-deformable shells have regions";
        return Some(finding(key, found, expected).rests_on([owner]));
    };
    if shell.region(region).is_some() {
        return None;
    }
    let names = shell.mesh.groups.iter().filter(|(_, group)| !group.elements.is_empty());
    Some(finding(key, found, named("elements", names.map(|(name, _)| name.as_str()))).rests_on([owner]))
}

/// Elements of a shell or of a region of it.
pub(crate) fn elements_of(body: &Body, region: Option<&str>) -> Vec<usize> {
    let all = || (0..body.elements() as usize).collect();
    body.shear_shell().map_or_else(all, |shell| shell.region(region).unwrap_or_default())
}

/// Expected name of a group of a mesh.
pub(crate) fn named<'a>(what: &str, names: impl Iterator<Item = &'a str>) -> String {
    let names: Vec<_> = names.map(quoted).collect();
    match names.is_empty() {
        true => format!("the name of a group with {what}, but the mesh has none"),
        false => format!("the name of a group with {what}: {}", listed(names, "or")),
    }
}

/// Finding for an axis without a projection on a shell. `key` is the path of the axis.
pub(crate) fn axis_on_shell(key: String, axis: [f64; 3], body: Option<(String, &Body)>) -> Option<Finding> {
    let (owner, body) = body.unzip();
    let normal_along = |axis| match body? {
        Body::Shell(shell) => shell.normal_along(axis),
        Body::ShearShell(shell) => shell.normal_along(axis),
        _ => None,
    };
    no_projection(key, axis, normal_along, owner.unwrap_or_default())
}

/// Finding for an axis without a projection on a surface. `normal_along` describes a place whose normal has the direction of the axis, and
/// `rests_on` is the path of the surface.
pub(crate) fn no_projection(
    key: String,
    axis: [f64; 3],
    normal_along: impl FnOnce([f64; 3]) -> Option<String>,
    rests_on: String,
) -> Option<Finding> {
    if !is_direction(axis) {
        return Some(no_direction(key, axis));
    }
    let expected = "an axis that is nowhere normal to the surface";
    normal_along(axis).map(|found| finding(key, found, expected).rests_on([rests_on]))
}
