//! Checks of loads beyond the schema, except those of functions of time.

use super::findings::unknown_body;
use crate::errors::{Finding, finding, number, quoted};
use crate::model::{About, Analysis, IndexedModel, Load, Probe, Quantity, loads_of};

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

/// Checks that each body, or each region of a shell, is in at most one fluid, once.
pub(crate) fn fluids(model: &IndexedModel<'_>) -> Vec<Finding> {
    let (mut findings, mut wet) = (Vec::new(), Vec::new());
    for (path, load) in loads_of(model) {
        let region = match load {
            Load::Fluid(_) => None,
            Load::SurfaceFluid(fluid) => fluid.region.as_deref(),
            _ => continue,
        };
        for (key, name) in load.kind().bodies() {
            let shell = model.named(name).and_then(|(_, body)| body.shear_shell());
            let elements =
                |part: Option<&str>| shell.and_then(|shell| shell.region(part)).unwrap_or_default();
            let own = elements(region);
            let overlaps = |(other, part): &(&str, Option<&str>)| {
                *other == name && (shell.is_none() || elements(*part).iter().any(|k| own.contains(k)))
            };
            if wet.iter().any(overlaps) {
                let found = format!("{} a second time", quoted(name));
                let error = finding(format!("{path}.{key}"), found, "each body in one fluid, once");
                findings.push(error.rests_on(["loads".into()]));
            }
            wet.push((name, region));
        }
    }
    findings
}

/// Number of instants of a motion at which amounts of gas are evaluated.
const INSTANTS: u32 = 128;

/// Rejects negative amounts of gas, and gases in models with gaps that are closed first.
pub(crate) fn gases(model: &IndexedModel<'_>) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, load) in loads_of(model) {
        let Load::Gas(gas) = load else { continue };
        if model.assemble {
            let expected = "false with a gas, whose volume would change before the analysis";
            findings.push(finding("assemble".into(), "true", expected).rests_on([path.clone()]));
        }
        let duration = model.analysis.dynamics().map_or(0.0, |dynamics| dynamics.duration);
        let instant = |k| model.initial.start_time + duration * f64::from(k) / f64::from(INSTANTS);
        let Ok(amount) = gas.time.compile() else { continue };
        let lowest = (0..=INSTANTS).map(instant).map(|t| (t, amount.value(t))).find(|(_, m)| *m < 0.0);
        if let Some((t, m)) = lowest {
            let found = format!("an amount of gas of {} at t = {}", number(m), number(t));
            findings.push(finding(format!("{path}.time"), found, "an amount of at least 0"));
        }
    }
    findings
}

/// Rejects motions of the ground that are undefined: with a fluid, whose current relative to the ground is not known, and rotations
/// about more than one axis.
pub(crate) fn bases(model: &IndexedModel<'_>) -> Vec<Finding> {
    let wet = loads_of(model).any(|(_, load)| matches!(load, Load::Fluid(_) | Load::SurfaceFluid(_)));
    let mut rotates = false;
    let base = |(path, load): (String, &Load)| {
        let is_rotation = matches!(load, Load::BaseRotation(_));
        let is_second = is_rotation && rotates;
        rotates |= is_rotation;
        let [found, expected] = if is_second {
            ["a second rotation of the ground", "one rotation: the sum of the angular velocities"]
        } else if wet && (is_rotation || matches!(load, Load::BaseAcceleration(_))) {
            [
                "an accelerating ground in a model with a fluid",
                "one or the other: how the fluid follows the ground is not known",
            ]
        } else {
            return None;
        };
        Some(finding(format!("{path}.kind"), found, expected).rests_on(["loads".into()]))
    };
    let is_motion = model.analysis.dynamics().is_some();
    let jump = |(path, load): (String, &Load)| {
        let jumps = is_motion
            && matches!(load, Load::BaseRotation(_))
            && load.time().is_some_and(|time| time.jumps(model.end_time()));
        let found = "a jump of the angular velocity of the ground, whose impulse the forces lack";
        jumps.then(|| finding(format!("{path}.time"), found, "a continuous function, such as a short ramp"))
    };
    loads_of(model).filter_map(base).chain(loads_of(model).filter_map(jump)).collect()
}

/// Rejects inertial sensors on a moving ground: they would lack its acceleration and rotation.
pub(crate) fn sensors(model: &IndexedModel<'_>) -> Vec<Finding> {
    let moves = |(_, load): (_, &Load)| matches!(load, Load::BaseRotation(_) | Load::BaseAcceleration(_));
    if !loads_of(model).any(moves) {
        return Vec::new();
    }
    let is_sensor = |probe: &(usize, &Probe)| probe.1.record.contains(&Quantity::InertialSensor);
    let found = "\"inertial_sensor\" on a moving ground";
    let expected = "no motion of the ground, or \"motion\" and \"rotation\", which are relative to it";
    let error = |(i, _): (usize, &Probe)| {
        finding(format!("probes[{i}].record"), found, expected).rests_on(["loads".into()])
    };
    model.probes.iter().enumerate().filter(is_sensor).map(error).collect()
}

/// Rejects modes on a rotating ground without Coriolis forces, or about a state without centrifugal forces.
pub(crate) fn rotating_modes(model: &IndexedModel<'_>) -> Vec<Finding> {
    let Analysis::Modes(modes) = &model.analysis else { return Vec::new() };
    if !loads_of(model).any(|(_, load)| matches!(load, Load::BaseRotation(_))) {
        return Vec::new();
    }
    let error = |key: &str, found: &str, expected: &str| {
        finding(format!("analysis.{key}"), found, expected).rests_on(["loads".into(), "analysis.kind".into()])
    };
    let undamped = (!modes.damped).then(|| {
        let found = "modes without gyroscopic forces on a rotating ground";
        error("damped", found, "`true`: Coriolis forces couple the modes")
    });
    let unloaded = (modes.about == About::Reference).then(|| {
        let found = "modes about the undeformed state on a rotating ground";
        error("about", found, "\"equilibrium\", the state of steady rotation")
    });
    undamped.into_iter().chain(unloaded).collect()
}

/// Rejects damped modes in a current about the undeformed state, which has no loads and thus no drag.
pub(crate) fn modes_in_currents(model: &IndexedModel<'_>) -> Vec<Finding> {
    let Analysis::Modes(modes) = &model.analysis else { return Vec::new() };
    let flows = |load: &Load| match load {
        Load::Fluid(fluid) => fluid.current != [0.0; 3],
        Load::SurfaceFluid(fluid) => fluid.current != [0.0; 3],
        _ => false,
    };
    if !modes.damped || modes.about != About::Reference || !loads_of(model).any(|(_, load)| flows(load)) {
        return Vec::new();
    }
    let found = "damped modes in a current about the undeformed state, which has no drag";
    let expected = "\"equilibrium\", the state in the current";
    let rests = ["loads".into(), "analysis.damped".into()];
    vec![finding("analysis.about".into(), found, expected).rests_on(rests)]
}
