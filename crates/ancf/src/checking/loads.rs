//! The rules of loads that the schema cannot say, but for those of functions of time.

use super::findings::{named, unknown_body};
use crate::errors::{Finding, finding, number, quoted};
use crate::model::{At, Beam, Body, Load, Model, ON_AXIS, loads_of};

/// Loads per length are on bodies that are there, on a part of them that has a length.
pub(crate) fn stretches(model: &Model) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, load) in loads_of(model) {
        let Some(on) = load.stretch() else { continue };
        let Some((owner, body)) = named(model, on.body) else {
            findings.push(unknown_body(model, format!("{path}.body"), on.body));
            continue;
        };
        if !body.is_flexible() {
            let found = format!("a load per length of {}, which has none", quoted(on.body));
            findings.push(finding(format!("{path}.body"), found, "a beam or a cable").rests_on([owner]));
            continue;
        }
        let length = body.length();
        if length <= 0.0 {
            continue; // Another rule says so.
        }
        let rests_on = |keys: &[&str]| {
            let axis = ["from", "to", "shape"].map(|key| format!("{owner}.{key}"));
            axis.into_iter().chain(keys.iter().map(|key| format!("{path}.{key}"))).collect::<Vec<_>>()
        };
        let [from, to] = [on.from, on.to].map(|at| body.arc_length(at));
        let beyond = |s: f64| s > length * (1.0 + ON_AXIS);
        let wanted = format!("at most {}, the length of {}", number(length), quoted(body.name()));
        for (key, s) in [("from", from), ("to", to)].into_iter().filter(|(_, s)| beyond(*s)) {
            let error = finding(format!("{path}.{key}"), number(s), wanted.clone());
            findings.push(error.rests_on(rests_on(&["body"])));
        }
        if !beyond(from) && !beyond(to) && to - from <= length * ON_AXIS {
            let key = if matches!(on.to, At::Length(_)) { "to" } else { "from" };
            let found = format!("a load from {} to {}", number(from), number(to));
            let error = finding(format!("{path}.{key}"), found, "a part of the body that has a length");
            findings.push(error.rests_on(rests_on(&["body", "from", "to"])));
        }
    }
    findings
}

/// Fluids are around bodies that are there, each in one, whose diameter is known.
pub(crate) fn fluids(model: &Model) -> Vec<Finding> {
    let (mut findings, mut wet) = (Vec::new(), Vec::new());
    for (path, load) in loads_of(model) {
        let Load::Fluid(fluid) = load else { continue };
        for (i, name) in fluid.bodies.iter().enumerate() {
            let key = format!("{path}.bodies[{i}]");
            let Some((owner, body)) = named(model, name) else {
                findings.push(unknown_body(model, key, name));
                continue;
            };
            if wet.contains(&name) {
                let found = format!("{} a second time", quoted(name));
                let error = finding(key, found, "each body in one fluid, once");
                findings.push(error.rests_on(["loads".into()]));
                continue;
            }
            wet.push(name);
            let Some((section, _)) = body.section_and_material() else {
                let found = format!("{}, which is rigid", quoted(name));
                findings.push(finding(key, found, "a beam or a cable").rests_on([owner]));
                continue;
            };
            let end = match body {
                Body::Beam(Beam { section_end, .. }) => section_end.as_deref(),
                _ => None,
            };
            let mut sections = [Some(section), end].into_iter().flatten();
            let shapeless =
                sections.find(|&name| model.sections.get(name).is_some_and(|s| fluid.hull(s).is_none()));
            if let Some(section) = shapeless {
                let wanted = format!("the diameter of {} that meets the flow, a number > 0", quoted(name));
                let error = finding(format!("{path}.diameter"), "no key `diameter`", wanted)
                    .hint("the section is not round");
                let rests_on = [format!("{path}.diameter"), format!("sections.{section}"), owner];
                findings.push(Finding { absence: true, ..error.rests_on(rests_on) });
            }
        }
    }
    findings
}

/// The current of a fluid is not known to a base that accelerates.
pub(crate) fn bases(model: &Model) -> Vec<Finding> {
    let wet = loads_of(model).any(|(_, load)| matches!(load, Load::Fluid(_)));
    let base = |(path, load): (String, &Load)| {
        (wet && matches!(load, Load::BaseAcceleration { .. })).then(|| {
            let found = "an accelerating ground in a model with a fluid";
            let wanted = "one or the other: how the fluid follows the ground is not known";
            finding(format!("{path}.kind"), found, wanted).rests_on(["loads".into()])
        })
    };
    loads_of(model).filter_map(base).collect()
}
