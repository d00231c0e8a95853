//! Checks of contacts beyond the schema.

use ancf_mechanics::contact::ObstacleShape;

use super::findings::{body, rule_of_place, unknown_body};
use crate::errors::{Finding, finding, is_direction, no_direction, number, quoted};
use crate::model::{Body, Contact, IndexedModel, ObstacleKind, bodies_of};

/// Checks that bodies exist and have a radius, and that obstacles have a direction and a carrier with directions.
pub(crate) fn contacts(model: &IndexedModel<'_>) -> Vec<Finding> {
    let each = model.contacts.iter().enumerate();
    each.flat_map(|(i, contact)| rules_of_contact(model, &format!("contacts[{i}]"), contact)).collect()
}

fn rules_of_contact(model: &IndexedModel<'_>, path: &str, contact: &Contact) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (i, name) in contact.bodies.iter().enumerate() {
        let key = format!("{path}.bodies[{i}]");
        let Some((_, body)) = model.named(name) else {
            findings.push(unknown_body(model, key, name));
            continue;
        };
        if !contact.touches(body) {
            let rigid = |more: &str| format!("{}, which is rigid{more}", quoted(name));
            let (found, expected) = match contact.with.obstacle() {
                Some(_) => {
                    (rigid(" and has no `surface`"), "a beam, a cable, a shell or a body with a `surface`")
                }
                None => (rigid(""), "a beam, a cable or a shell"),
            };
            findings.push(finding(key, found, expected).rests_on(["bodies".into()]));
        } else if contact.bodies[..i].contains(name) {
            findings.push(finding(key, format!("{} a second time", quoted(name)), "each body once"));
        }
    }
    let bare = contact.bodies(model).into_iter().map(|i| &model.bodies[i]);
    let bare = bare.filter(|body| {
        body.section_and_material().is_some_and(|(name, _)| model.sections.contains_key(name))
    });
    if let Some(body) = bare.into_iter().find(|body| contact.radius(model, body).is_none()) {
        let found = format!("no radius of {}, whose section is not one circle or tube", quoted(body.name()));
        let error = finding(path.to_owned(), found, "a key `radius`, or other `bodies`");
        let rests_on = ["bodies".into(), "sections".into(), format!("{path}.bodies")];
        findings.push(Finding { absence: true, ..error.rests_on(rests_on) });
    }
    let direction = contact.with.obstacle().and_then(ObstacleKind::axis);
    if let Some((key, direction)) = direction.filter(|(_, direction)| !is_direction(*direction)) {
        findings.push(no_direction(format!("{path}.with.{key}"), direction));
    }
    findings.extend(rules_of_carrier(model, path, contact));
    findings.extend(rule_of_partners(model, path, contact));
    findings.extend(rules_of_stiffness(model, path, contact));
    findings.extend(rules_of_boxes(model, path, contact));
    findings
}

/// Checks that some body can touch the partner.
fn rule_of_partners(model: &IndexedModel<'_>, path: &str, contact: &Contact) -> Option<Finding> {
    if !contact.bodies.is_empty() || !contact.bodies(model).is_empty() {
        return None;
    }
    let found = "no body that can touch it";
    let expected = match contact.with.obstacle() {
        Some(_) => "a beam, a cable, a shell, or a rigid body or point mass with a `surface`",
        None => "a beam, a cable or a shell",
    };
    let error = finding(path.to_owned(), found, expected);
    Some(Finding { absence: true, ..error.rests_on(["bodies".into()]) })
}

/// Checks that the stiffness of each kind of body in contact is given, and no other, and that some body uses the radius.
fn rules_of_stiffness(model: &IndexedModel<'_>, path: &str, contact: &Contact) -> Vec<Finding> {
    let bodies = contact.bodies(model);
    let of = |is_shell: bool| bodies.iter().map(|i| &model.bodies[*i]).find(|b| b.is_shell() == is_shell);
    let kinds = [
        ("stiffness", contact.stiffness, of(false), "body other than a shell", "force/length²"),
        ("surface_stiffness", contact.surface_stiffness, of(true), "shell", "force/length³"),
    ];
    let rule = |(key, value, body, kind, unit): (&str, Option<f64>, Option<&Body>, &str, &str)| {
        let error = match (value, body) {
            (None, Some(body)) => {
                let found = format!("no key `{key}` for {}", quoted(body.name()));
                let expected = format!("a number > 0 ({unit}), since a {kind} is in contact");
                Finding { absence: true, ..finding(format!("{path}.{key}"), found, expected) }
            }
            (Some(value), None) if !bodies.is_empty() => {
                let expected = format!("no such key: no {kind} is in contact");
                finding(format!("{path}.{key}"), number(value), expected)
            }
            _ => return None,
        };
        Some(error.rests_on(["bodies".into(), format!("{path}.bodies")]))
    };
    let is_unused = |_: &f64| !bodies.is_empty() && !bodies.iter().any(|i| model.bodies[*i].is_flexible());
    let radius = contact.radius.filter(is_unused).map(|radius| {
        let expected = "no such key: no beam or cable is in contact";
        finding(format!("{path}.radius"), number(radius), expected)
            .rests_on(["bodies".into(), format!("{path}.bodies")])
    });
    kinds.into_iter().filter_map(rule).chain(radius).collect()
}

/// Rejects boxes in contact with convex obstacles, which touch faces and edges between the corners.
fn rules_of_boxes(model: &IndexedModel<'_>, path: &str, contact: &Contact) -> Vec<Finding> {
    let is_convex = match contact.with.obstacle().map(ObstacleKind::shape) {
        Some(ObstacleShape::Sphere { inside, .. } | ObstacleShape::Cylinder { inside, .. }) => !inside,
        _ => false,
    };
    let bodies = contact.bodies(model).into_iter().filter(|_| is_convex).map(|i| &model.bodies[i]);
    let boxes = bodies.filter(|body| body.surface().is_some_and(|surface| surface.edges.is_some()));
    let rule = |body: &Body| {
        let found = format!("the box {}, of which only the corners are in contact", quoted(body.name()));
        finding(format!("{path}.with.kind"), found, "a plane, or a `surface` of balls")
            .rests_on(["bodies".into()])
    };
    boxes.map(rule).collect()
}

/// Checks that surfaces state one shape of positive size, and that those of point masses are balls.
pub(crate) fn surfaces(model: &IndexedModel<'_>) -> Vec<Finding> {
    let rule = |(path, body): (String, &Body)| {
        let surface = body.surface()?;
        let key = format!("{path}.surface");
        let other = surface.edges.is_some() || !surface.points.is_empty();
        if surface.edges.is_some() && !surface.points.is_empty() {
            return Some(finding(key, "both `edges` and `points`", "one of them"));
        }
        if matches!(body, Body::Mass(_)) && other {
            return Some(finding(key, "`edges` or `points` of a point mass", "`radius`"));
        }
        if let Some(edges) = surface.edges.filter(|edges| edges.iter().any(|edge| *edge <= 0.0)) {
            let found = format!("edges {}, {}, {}", number(edges[0]), number(edges[1]), number(edges[2]));
            return Some(finding(format!("{key}.edges"), found, "three numbers > 0"));
        }
        let empty = surface.size(body.span()[0]) <= 0.0;
        empty.then(|| {
            finding(key, "a surface without size", "a `radius` > 0, `edges` of a box, or two `points`")
        })
    };
    bodies_of(model).filter_map(rule).collect()
}

fn rules_of_carrier(model: &IndexedModel<'_>, path: &str, contact: &Contact) -> Vec<Finding> {
    let Some(place) = contact.with.on() else { return Vec::new() };
    let mut findings: Vec<_> = rule_of_place(model, format!("{path}.with.on"), place).into_iter().collect();
    let without = match body(model, place) {
        Some((_, Body::Cable(_))) => Some("an obstacle on a cable"),
        Some((_, Body::Mass(_))) => Some("an obstacle on a point mass"),
        _ => None,
    };
    if let Some(found) = without {
        let expected = "a beam or a rigid body, which has directions";
        let error = finding(format!("{path}.with.on.body"), found, expected);
        findings.push(error.rests_on(["bodies".into()]));
    }
    if let Some(i) = contact.bodies.iter().position(|body| *body == place.body) {
        let error = finding(
            format!("{path}.bodies[{i}]"),
            format!("{}, which carries the obstacle", quoted(&place.body)),
            "other bodies",
        );
        findings.push(error.rests_on([format!("{path}.with.on.body")]));
    }
    findings
}
