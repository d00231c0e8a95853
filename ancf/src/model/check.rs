//! The rules of a model that its schema cannot say.

use nalgebra::Vector3;

use super::schema::{listed, nearest, number, quoted};
use super::scheme::{scheme, time};
use super::survey::{Finding, did_you_mean};
use super::{Beam, End, Joint, Load, Model, ModelError, Place, ScaleChoice};

/// Elements beyond which a model is taken for a slip of the pen.
const MAX_ELEMENTS: u64 = 10_000_000;
/// Memory that a run needs for an element.
const BYTES_PER_ELEMENT: f64 = 12e3;
/// Rounding of a position along an axis, relative to its length.
const ON_AXIS: f64 = 1e-9;
/// How far apart, relative to the longer body, two places may be that a joint connects.
const COINCIDENT: f64 = 1e-6;

/// The rules that a model breaks.
pub(super) fn broken_rules(model: &Model) -> Vec<Finding> {
    let rules = [names, columns, beams, size, places, joints, time, scheme, scales];
    rules.iter().flat_map(|rule| rule(model)).collect()
}

pub(super) fn finding(path: String, found: impl Into<String>, wanted: impl Into<String>) -> Finding {
    ModelError::new(path, found, wanted).into()
}

impl Finding {
    pub(super) fn hint(mut self, hint: impl Into<String>) -> Self {
        self.error = self.error.hint(hint);
        self
    }

    pub(super) fn rests_on(self, paths: impl IntoIterator<Item = String>) -> Self {
        Self { rests_on: paths.into_iter().collect(), ..self }
    }
}

fn beams_of(model: &Model) -> impl Iterator<Item = (String, &Beam)> {
    model.bodies.iter().enumerate().map(|(i, body)| (format!("bodies[{i}]"), body.beam()))
}

fn joints_of(model: &Model) -> impl Iterator<Item = (String, &Joint)> {
    model.joints.iter().enumerate().map(|(i, joint)| (format!("joints[{i}]"), joint))
}

/// Every body has a name of its own.
fn names(model: &Model) -> Vec<Finding> {
    rule_of_names(beams_of(model).map(|(path, beam)| (path, &*beam.name)).collect())
}

/// Joints and probes make columns of the outputs by their names.
fn columns(model: &Model) -> Vec<Finding> {
    let joints = joints_of(model).map(|(path, joint)| (path, joint.name()));
    let probes = model.probes.iter().enumerate().map(|(i, probe)| (format!("probes[{i}]"), &*probe.name));
    rule_of_names(joints.chain(probes).collect())
}

fn rule_of_names(names: Vec<(String, &str)>) -> Vec<Finding> {
    let unfit =
        |name: &str| name.trim() != name || name.contains(|c: char| c.is_control() || ",.'\"".contains(c));
    let spaced = names.iter().filter(|(_, name)| unfit(name)).map(|(path, name)| {
        finding(
            format!("{path}.name"),
            quoted(name),
            "a name without dot, comma, quotes or outer spaces, for use in columns",
        )
    });
    let twice = names.iter().enumerate().filter_map(|(i, (path, name))| {
        let (first, _) = names[..i].iter().find(|(_, other)| other == name)?;
        let found = format!("{} a second time", quoted(name));
        let wanted = format!("a name of its own; `{first}` has this one");
        Some(finding(format!("{path}.name"), found, wanted).rests_on([format!("{first}.name")]))
    });
    spaced.chain(twice).collect()
}

/// Sections and materials are there; the axis and the direction `up` span a plane.
fn beams(model: &Model) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, beam) in beams_of(model) {
        let sections = || model.sections.keys().map(String::as_str).collect();
        let materials = || model.materials.keys().map(String::as_str).collect();
        if !model.sections.contains_key(&beam.section) {
            let error = unknown(format!("{path}.section"), "section", &beam.section, sections());
            findings.push(error.rests_on(["sections".into()]));
        }
        if !model.materials.contains_key(&beam.material) {
            let error = unknown(format!("{path}.material"), "material", &beam.material, materials());
            findings.push(error.rests_on(["materials".into()]));
        }
        findings.extend(rule_of_axis(&path, beam));
    }
    findings
}

fn rule_of_axis(path: &str, beam: &Beam) -> Option<Finding> {
    let axis = [format!("{path}.from"), format!("{path}.to")];
    match (beam.length(), beam.up) {
        (0.0, _) => {
            let error =
                finding(format!("{path}.to"), "a beam of length 0", "an end of the axis away from its start");
            Some(error.rests_on(axis))
        }
        (length, _) if !length.is_finite() => Some(
            finding(format!("{path}.to"), "an axis too long for its length to be a number", "a shorter one")
                .rests_on(axis),
        ),
        (_, Some(up)) if !is_direction(up) => Some(no_direction(format!("{path}.up"), up)),
        (_, Some(_)) if beam.frame().is_none() => {
            Some(finding(format!("{path}.up"), "a direction along the axis", "one across it").rests_on(axis))
        }
        _ => None,
    }
}

/// Whether a vector has a direction, as numbers go.
fn is_direction(vector: [f64; 3]) -> bool {
    Vector3::from(vector).norm().is_normal()
}

fn no_direction(path: String, vector: [f64; 3]) -> Finding {
    finding(path, format!("a vector of length {}", number(Vector3::from(vector).norm())), "a direction")
}

/// A reference to something that the model does not have.
fn unknown(path: String, noun: &str, name: &str, names: Vec<&str>) -> Finding {
    let wanted = match names.len() {
        0 => format!("the name of a {noun}, but there is none"),
        1..=8 => format!("the name of a {noun}: {}", listed(names.iter().map(|name| quoted(name)), "or")),
        n => format!("the name of one of the {n} {noun}s"),
    };
    let error = ModelError::new(path, quoted(name), wanted);
    Finding { absence: true, ..did_you_mean(error, nearest(name, names).map(quoted)).into() }
}

/// The mesh fits into the memory of a computer.
fn size(model: &Model) -> Vec<Finding> {
    let total: u64 = beams_of(model).map(|(_, beam)| u64::from(beam.elements)).sum();
    let largest = beams_of(model).max_by_key(|(_, beam)| beam.elements).filter(|_| total > MAX_ELEMENTS);
    let error = largest.map(|(path, _)| {
        let memory = total as f64 * BYTES_PER_ELEMENT / 1e9;
        let wanted = format!("at most {MAX_ELEMENTS} over all bodies");
        finding(format!("{path}.elements"), format!("{total} elements in all"), wanted)
            .hint(format!("they would need about {memory:.0} GB of memory"))
            .rests_on(beams_of(model).map(|(path, _)| format!("{path}.elements")))
    });
    error.into_iter().collect()
}

/// Places are on bodies that are there.
fn places(model: &Model) -> Vec<Finding> {
    let loads =
        model.loads.iter().enumerate().map(|(i, Load::Force { on, .. })| (format!("loads[{i}].on"), on));
    let probes = model.probes.iter().enumerate().map(|(i, probe)| (format!("probes[{i}].on"), &probe.on));
    let ends = joints_of(model).flat_map(|(path, joint)| {
        let (a, b) = joint.ends();
        let b = if let End::Place(b) = b { Some((format!("{path}.b"), b)) } else { None };
        [(format!("{path}.a"), a)].into_iter().chain(b)
    });
    ends.chain(loads).chain(probes).filter_map(|(path, place)| rule_of_place(model, path, place)).collect()
}

fn rule_of_place(model: &Model, path: String, place: &Place) -> Option<Finding> {
    let Some((body, beam)) = body(model, place) else {
        let names = beams_of(model).map(|(_, beam)| &*beam.name).collect();
        let error = unknown(format!("{path}.body"), "body", &place.body, names);
        return Some(error.rests_on(beams_of(model).map(|(path, _)| format!("{path}.name"))));
    };
    let (s, length) = (beam.arc_length(place.at), beam.length());
    let beyond = length > 0.0 && s > length * (1.0 + ON_AXIS);
    beyond.then(|| {
        let wanted = format!("at most {}, the length of {}", number(length), quoted(&beam.name));
        let rests_on = [format!("{body}.from"), format!("{body}.to"), format!("{path}.body")];
        finding(format!("{path}.at"), number(s), wanted).rests_on(rests_on)
    })
}

/// The first body of a name; that there is only one is another rule.
fn body<'m>(model: &'m Model, place: &Place) -> Option<(String, &'m Beam)> {
    beams_of(model).find(|(_, beam)| beam.name == place.body)
}

/// Joints connect two places that coincide in the undeformed state; hinges have an axis.
fn joints(model: &Model) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, joint) in joints_of(model) {
        if let Joint::Revolute { axis, .. } = joint
            && !is_direction(*axis)
        {
            findings.push(no_direction(format!("{path}.axis"), *axis));
        }
        if let (a, End::Place(b)) = joint.ends() {
            findings.extend(rule_of_joint(model, &path, a, b));
        }
    }
    findings
}

fn rule_of_joint(model: &Model, path: &str, a: &Place, b: &Place) -> Option<Finding> {
    let ((body_a, beam_a), (body_b, beam_b)) = (body(model, a)?, body(model, b)?);
    let (s_a, s_b) = (beam_a.arc_length(a.at), beam_b.arc_length(b.at));
    let length = beam_a.length().max(beam_b.length());
    if body_a == body_b && (s_a - s_b).abs() <= ON_AXIS * length {
        let wanted = "a place on another body, or \"ground\"";
        return Some(
            finding(format!("{path}.b"), "the same place as `a`", wanted)
                .rests_on(ends(path, &body_a, &body_b)),
        );
    }
    let (r_a, r_b) = (point(beam_a, s_a)?, point(beam_b, s_b)?);
    let apart = (r_a - r_b).norm();
    (apart > COINCIDENT * length).then(|| {
        let found = format!("a place that is {} away from `a`", number(apart));
        let at = |r: Vector3<f64>| format!("[{}, {}, {}]", number(r.x), number(r.y), number(r.z));
        finding(format!("{path}.b"), found, "places that coincide in the undeformed state")
            .hint(format!("`a` is at {}, `b` at {}", at(r_a), at(r_b)))
            .rests_on(ends(path, &body_a, &body_b))
    })
}

/// What the places of a joint rest on.
fn ends(path: &str, body_a: &str, body_b: &str) -> Vec<String> {
    let places = ["a.body", "a.at", "b.body", "b.at"].map(|key| format!("{path}.{key}"));
    let axes = [body_a, body_b].into_iter().flat_map(|body| [format!("{body}.from"), format!("{body}.to")]);
    places.into_iter().chain(axes).collect()
}

/// The point of an undeformed axis at arc length s, if the axis reaches that far.
fn point(beam: &Beam, s: f64) -> Option<Vector3<f64>> {
    let (from, to) = (Vector3::from(beam.from), Vector3::from(beam.to));
    let length = beam.length();
    (length > 0.0 && s <= length * (1.0 + ON_AXIS)).then(|| from + (to - from) * (s / length))
}

/// The scales of the paper are for its model.
fn scales(model: &Model) -> Vec<Finding> {
    let path = || "scales.kind".to_owned();
    let hint = "\"auto\" and \"given\" suit any model";
    let mut findings = Vec::new();
    if model.scales == ScaleChoice::Paper && model.bodies.len() != 1 {
        let found = format!("\"paper\" in a model of {} bodies", model.bodies.len());
        findings.push(finding(path(), found, "a model of one body").hint(hint).rests_on(["bodies".into()]));
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
