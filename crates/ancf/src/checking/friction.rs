//! Rejects friction in equilibria, whose friction forces depend on the motion that led to them.

use crate::errors::{Finding, finding, number};
use crate::joints::Joint;
use crate::model::{About, Analysis, IndexedModel, joints_of};

/// Checks that contacts and joints have friction in analyses with a motion only.
pub(crate) fn friction(model: &IndexedModel<'_>) -> Vec<Finding> {
    let analysis = match &model.analysis {
        Analysis::Statics(_) => "statics",
        Analysis::Path(_) => "an equilibrium path",
        Analysis::Modes(modes) if modes.about == About::Equilibrium => "modes about an equilibrium",
        _ => return Vec::new(),
    };
    let rule = |path: String, amount: f64| {
        (amount != 0.0).then(|| {
            let found = format!("{} in {analysis}, which has no motion", number(amount));
            let error = finding(path, found, "0, or an analysis of kind \"dynamics\"");
            error
                .hint("the equilibrium with friction depends on the motion that leads to it: dynamics with damping and slow loads")
                .rests_on(["analysis".into()])
        })
    };
    let contacts = model.contacts.iter().enumerate();
    let of_contacts =
        contacts.filter_map(|(i, contact)| rule(format!("contacts[{i}].friction"), contact.friction));
    let of_joints = joints_of(model).filter_map(|(path, joint)| {
        let friction = joint.kind().friction()?;
        rule(format!("{path}.friction"), friction.amount.max(friction.coefficient))
    });
    of_contacts.chain(of_joints).collect()
}

/// Checks that friction of joints states the lengths and rates on which it depends, and where it is permitted.
pub(crate) fn friction_of_joints(model: &IndexedModel<'_>) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, joint) in joints_of(model) {
        let (kind, actions) = (joint.kind(), joint.kind().displacement_actions());
        let Some(friction) = kind.friction() else { continue };
        let key = |key: &str| format!("{path}.friction.{key}");
        let missing = |key: String, found: &str, expected: &str| Finding {
            absence: true,
            ..finding(key, found, expected)
        };
        let (by_reaction, keys) = (friction.coefficient > 0.0, kind.bearing_keys());
        let also_turns = matches!(joint, Joint::Cylindrical(_));
        if keys.contains(&"radius") && (by_reaction || also_turns) && friction.radius.is_none() {
            let (found, expected) = match also_turns {
                true => ("no radius", "the radius of the shaft, at which the rotation slips"),
                false => (
                    "no radius beside a coefficient",
                    "the radius of the pin or ball, on which the reaction acts",
                ),
            };
            findings.push(missing(key("radius"), found, expected));
        }
        for (name, length) in friction.lengths().filter(|(name, _)| !keys.contains(name)) {
            let expected = format!("no `{name}`: the friction of a {} does not depend on it", kind.noun());
            findings.push(finding(key(name), number(length), expected));
        }
        if friction.curve.peak > 1.0 && !friction.has_decay {
            let expected = "the rate over which friction falls from its peak";
            findings.push(missing(key("decay"), "no decay beside a peak", expected));
        }
        let acts = actions.drive.is_some() || actions.spring.is_some() || actions.law.is_some();
        let is_slide = matches!(joint, Joint::Slide(_));
        if by_reaction && is_slide && (acts || actions.stops.is_some() || friction.amount > 0.0) {
            let expected = "0, or a slide without other forces along the beam, also without `force` of the friction, since its reaction contains them";
            findings.push(finding(key("coefficient"), number(friction.coefficient), expected));
        }
        if by_reaction && model.output.errors {
            let expected = "false with friction by reactions, whose errors are not estimated";
            let error = finding("output.errors".into(), "true", expected);
            findings.push(error.rests_on([format!("{path}.friction")]));
        }
    }
    findings
}
