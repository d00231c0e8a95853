//! Checks of loads beyond the schema, except those of functions of time.

use super::findings::unknown_body;
use crate::errors::{Finding, finding, quoted};
use crate::model::{IndexedModel, Load, loads_of};

/// Checks that named bodies exist, and the checks of the kinds of loads.
pub(crate) fn kinds(model: &IndexedModel<'_>) -> Vec<Finding> {
    let findings = |(path, load): (String, &Load)| {
        let bodies = load.kind().bodies();
        let unknown = bodies.into_iter().filter(|(_, name)| model.named(name).is_none());
        let mut findings: Vec<Finding> =
            unknown.map(|(key, name)| unknown_body(model, format!("{path}.{key}"), name)).collect();
        findings.extend(load.kind().check(&path, model));
        findings
    };
    loads_of(model).flat_map(findings).collect()
}

/// Checks that each body is in at most one fluid, once.
pub(crate) fn fluids(model: &IndexedModel<'_>) -> Vec<Finding> {
    let (mut findings, mut wet) = (Vec::new(), Vec::new());
    for (path, load) in loads_of(model) {
        let Load::Fluid(fluid) = load else { continue };
        for (i, name) in fluid.bodies.iter().enumerate() {
            if wet.contains(&name) {
                let found = format!("{} a second time", quoted(name));
                let error = finding(format!("{path}.bodies[{i}]"), found, "each body in one fluid, once");
                findings.push(error.rests_on(["loads".into()]));
            }
            wet.push(name);
        }
    }
    findings
}

/// Rejects a fluid together with an accelerating base: the current relative to the base is undefined.
pub(crate) fn bases(model: &IndexedModel<'_>) -> Vec<Finding> {
    let wet = loads_of(model).any(|(_, load)| matches!(load, Load::Fluid(_)));
    let base = |(path, load): (String, &Load)| {
        (wet && matches!(load, Load::BaseAcceleration(_))).then(|| {
            let found = "an accelerating ground in a model with a fluid";
            let expected = "one or the other: how the fluid follows the ground is not known";
            finding(format!("{path}.kind"), found, expected).rests_on(["loads".into()])
        })
    };
    loads_of(model).filter_map(base).collect()
}
