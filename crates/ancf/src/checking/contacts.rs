//! Checks of contacts beyond the schema.

use super::findings::{body, is_direction, named, no_direction, rule_of_place, unknown_body};
use crate::errors::{Finding, finding, quoted};
use crate::model::{Body, Contact, Model, ObstacleKind};

/// Checks that bodies exist and have a radius, and that obstacles have a direction and a carrier with directions.
pub(crate) fn contacts(model: &Model) -> Vec<Finding> {
    let each = model.contacts.iter().enumerate();
    each.flat_map(|(i, contact)| rules_of_contact(model, &format!("contacts[{i}]"), contact)).collect()
}

fn rules_of_contact(model: &Model, path: &str, contact: &Contact) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (i, name) in contact.bodies.iter().enumerate() {
        let key = format!("{path}.bodies[{i}]");
        let Some((_, body)) = named(model, name) else {
            findings.push(unknown_body(model, key, name));
            continue;
        };
        if !body.is_flexible() {
            let found = format!("{}, which is rigid", quoted(name));
            findings.push(finding(key, found, "a beam or a cable").rests_on(["bodies".into()]));
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
    findings
}

fn rules_of_carrier(model: &Model, path: &str, contact: &Contact) -> Vec<Finding> {
    let Some(place) = contact.with.on() else { return Vec::new() };
    let mut findings: Vec<_> = rule_of_place(model, format!("{path}.with.on"), place).into_iter().collect();
    let without = match body(model, place) {
        Some((_, Body::Cable(_))) => Some("an obstacle on a cable"),
        Some((_, Body::Mass(_))) => Some("an obstacle on a point mass"),
        _ => None,
    };
    if let Some(found) = without {
        let wanted = "a beam or a rigid body, which has directions";
        let error = finding(format!("{path}.with.on.body"), found, wanted);
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
