//! Checks of a model beyond its schema: names, sizes, places, scales; and the list of all checks.

use nalgebra::Vector3;

use super::bodies::{bodies, cables, formulations};
use super::capabilities::capabilities;
use super::contacts::contacts;
use super::findings::{COINCIDENT, body, places_of, rule_of_names, rule_of_place};
use super::memory::{MAX_ELEMENTS, memory_of};
use super::scheme::{errors, scheme, time};
use crate::errors::{Finding, finding, number};
use crate::joints::{End, Joint};
use crate::loads::Load;
use crate::model::{
    About, Analysis, IndexedModel, Initial, Model, Modes, ON_AXIS, Origin, Place, Statics, bodies_of,
    joints_of, loads_of,
};
use crate::schema::join;
use crate::units::ScaleChoice;

/// Findings of all checks.
pub(crate) fn broken_rules(model: &Model) -> Vec<Finding> {
    let model = &IndexedModel::new(model);
    let rules = [
        names,
        columns,
        sections,
        bodies,
        formulations,
        cables,
        size,
        places,
        joints,
        time,
        scheme,
        errors,
        scales,
        initial,
    ];
    let of_times = [
        super::time_functions::functions,
        super::time_functions::ground_points,
        super::time_functions::inputs,
        super::time_functions::laws,
        capabilities,
    ];
    let of_loads = [
        contacts,
        super::contacts::surfaces,
        super::display::shapes,
        super::shells::shells,
        super::friction::friction,
        super::friction::friction_of_joints,
        super::loads::kinds,
        super::loads::fluids,
        super::loads::gases,
        super::loads::bases,
        super::loads::rotating_modes,
        super::loads::modes_in_currents,
        super::loads::sensors,
    ];
    let of_joints = [
        super::joints::axes,
        super::joints::spans,
        super::joints::lengths,
        super::joints::drives,
        super::joints::stops,
        super::joints::kinds,
        super::joints::couplings,
    ];
    let special = of_times.iter().chain(&of_loads).chain(&of_joints);
    rules.iter().chain(special).flat_map(|rule| rule(model)).collect()
}

/// Checks that bodies have unique names.
fn names(model: &IndexedModel<'_>) -> Vec<Finding> {
    rule_of_names(bodies_of(model).map(|(path, body)| (path, body.name())).collect())
}

/// Checks that joints, probes, gases and couplings, which name columns of results, have unique names.
fn columns(model: &IndexedModel<'_>) -> Vec<Finding> {
    let joints = joints_of(model).map(|(path, joint)| (path, joint.name()));
    let probes = model.probes.iter().enumerate().map(|(i, probe)| (format!("probes[{i}]"), &*probe.name));
    let couplings = model.couplings.iter().enumerate();
    let couplings = couplings.map(|(i, coupling)| (format!("couplings[{i}]"), &*coupling.name));
    // Names of external loads are those of functions, which several loads may use.
    let gases = loads_of(model)
        .filter_map(|(path, load)| if let Load::Gas(gas) = load { Some((path, &*gas.name)) } else { None });
    rule_of_names(joints.chain(probes).chain(gases).chain(couplings).collect())
}

/// Checks of the kinds of sections.
fn sections(model: &IndexedModel<'_>) -> Vec<Finding> {
    let sections = model.sections.iter();
    sections.flat_map(|(name, section)| section.shape().check(&join("sections", name))).collect()
}

/// Checks the number of elements and the memory of the model.
fn size(model: &IndexedModel<'_>) -> Vec<Finding> {
    let total: u64 = bodies_of(model).map(|(_, body)| u64::from(body.elements())).sum();
    let largest = bodies_of(model).max_by_key(|(_, body)| body.elements()).filter(|_| total > MAX_ELEMENTS);
    let error = largest.map(|(path, _)| {
        let expected = format!("at most {MAX_ELEMENTS} over all bodies");
        finding(format!("{path}.elements"), format!("{total} elements in all"), expected)
            .hint(memory_of(total as f64))
            .rests_on(bodies_of(model).map(|(path, _)| format!("{path}.elements")))
    });
    match error {
        Some(error) => vec![error],
        None => super::memory::memory(model, super::memory::available).into_iter().collect(),
    }
}

/// Checks that places are on existing bodies.
fn places(model: &IndexedModel<'_>) -> Vec<Finding> {
    places_of(model).filter_map(|(path, place)| rule_of_place(model, path, place)).collect()
}

/// Checks that joints connect places that coincide in the undeformed state.
fn joints(model: &IndexedModel<'_>) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, joint) in joints_of(model) {
        if let ((a, End::Place(b)), false) = (joint.ends(), joint.kind().spans()) {
            findings.extend(rule_of_joint(model, &path, joint, [a, b]));
        }
    }
    findings
}

fn rule_of_joint(
    model: &IndexedModel<'_>,
    path: &str,
    joint: &Joint,
    [a, b]: [&Place; 2],
) -> Option<Finding> {
    let ((path_a, body_a), (path_b, body_b)) = (body(model, a)?, body(model, b)?);
    let (r_a, r_b) = (model.point(a)?, model.point(b)?);
    let length = body_a.length().max(body_b.length());
    let length = if length > 0.0 { length } else { model.length() };
    let near = (body_a.arc_length(&a.at) - body_b.arc_length(&b.at)).abs() <= ON_AXIS * length;
    if joint.kind().is_distributed() {
        return None;
    }
    if path_a == path_b && near && (r_a - r_b).norm() <= ON_AXIS * length {
        let expected = "a place on another body, or \"ground\"";
        return Some(
            finding(format!("{path}.b"), "the same place as `a`", expected)
                .rests_on(ends(path, &path_a, &path_b)),
        );
    }
    let (apart, closes) = ((r_a - r_b).norm(), joint.kind().closes());
    (!(model.assemble && closes) && apart > COINCIDENT * length).then(|| {
        let found = format!("a place that is {} away from `a`", number(apart));
        let at = |r: Vector3<f64>| format!("[{}, {}, {}]", number(r.x), number(r.y), number(r.z));
        let who = if closes { "the gap" } else { "gaps of clamps, hinges and ball joints only" };
        finding(format!("{path}.b"), found, "places that coincide in the undeformed state")
            .hint(format!("`a` is at {}, `b` at {}; `assemble = true` closes {who}", at(r_a), at(r_b)))
            .rests_on(ends(path, &path_a, &path_b))
    })
}

/// Keys that determine the ends of a joint.
fn ends(path: &str, body_a: &str, body_b: &str) -> Vec<String> {
    let places = ["a.body", "a.at", "b.body", "b.at"].map(|key| format!("{path}.{key}"));
    let axes = [body_a, body_b];
    let axes = axes.into_iter().flat_map(|body| ["from", "to", "shape"].map(|key| format!("{body}.{key}")));
    places.into_iter().chain(axes).collect()
}

/// Checks that a time selects a state of a results folder, and that the analysis can start in a state.
fn initial(model: &IndexedModel<'_>) -> Vec<Finding> {
    let Initial { time, start_time, .. } = model.initial;
    let Some(folder) = model.starts_from() else {
        if let (Origin::Equilibrium, Some(what)) = (&model.initial.from, without_start(&model.analysis)) {
            let hint = "modes about an equilibrium: `analysis.about = \"equilibrium\"`";
            let error =
                finding("initial.from".into(), format!("an equilibrium for {what}"), STARTING).hint(hint);
            return vec![error.rests_on(["analysis".into()])];
        }
        let times = [("initial.time", time), ("initial.start_time", Some(start_time).filter(|t| *t != 0.0))];
        let stated = times.into_iter().filter_map(|(path, time)| Some((path, time?)));
        let expected = "no time without a results folder in `initial.from`";
        let rule = |(path, time): (&str, f64)| finding(path.into(), number(time), expected);
        return stated.map(|one| rule(one).rests_on(["initial.from".into()])).collect();
    };
    if let Analysis::Statics(Statics { load: 0.0, .. }) = model.analysis {
        let error = finding("analysis.load".into(), "0", Statics::RELEASING);
        return vec![error.rests_on(["initial.from".into()])];
    }
    if model.analysis.dynamics().is_some() {
        return Vec::new();
    }
    let start = without_start(&model.analysis).map(|what| {
        finding("initial.from".into(), format!("the results folder {folder:?} for {what}"), STARTING)
    });
    let start_time = (start_time != 0.0)
        .then(|| finding("initial.start_time".into(), number(start_time), "0 in an analysis without time"));
    start.into_iter().chain(start_time).map(|one| one.rests_on(["analysis".into()])).collect()
}

/// Analyses that start in a state.
const STARTING: &str =
    "\"undeformed\", or an analysis that starts in a state: dynamics, statics, modes about an equilibrium";

/// Name of an analysis of the reference state; `None` for those that start in a state.
const fn without_start(analysis: &Analysis) -> Option<&'static str> {
    match analysis {
        Analysis::Dynamics(_)
        | Analysis::Statics(_)
        | Analysis::Modes(Modes { about: About::Equilibrium, .. }) => None,
        Analysis::Modes(_) => Some("modes about the reference state"),
        Analysis::Path(_) => Some("a path"),
        Analysis::Buckling(_) => Some("critical loads"),
    }
}

/// Checks that the scales of the paper are used for a model like that of the paper.
fn scales(model: &IndexedModel<'_>) -> Vec<Finding> {
    let path = || "scales.kind".to_owned();
    let hint = "\"auto\" and \"given\" suit any model";
    let mut findings = Vec::new();
    if model.scales == ScaleChoice::Paper && model.bodies.len() != 1 {
        let found = format!("\"paper\" in a model of {} bodies", model.bodies.len());
        findings.push(finding(path(), found, "a model of one body").hint(hint).rests_on(["bodies".into()]));
    }
    if model.scales == ScaleChoice::Paper && model.bodies.iter().any(|body| !body.is_flexible()) {
        let found = "\"paper\" in a model with a rigid body";
        findings.push(finding(path(), found, "a model of one beam").hint(hint).rests_on(["bodies".into()]));
    }
    if model.scales == ScaleChoice::Paper && model.gravity == [0.0; 3] {
        let error = finding(
            path(),
            "\"paper\" in a model without gravity",
            "gravity, whose weight is the unit of force",
        );
        findings.push(error.hint(hint).rests_on(["gravity".into()]));
    }
    findings.into_iter().map(|error| Finding { absence: true, ..error }).collect()
}
