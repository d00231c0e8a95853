//! Rejects joints, loads and probes that a body does not support: a cable has only a tangent, a point mass no directions, a rigid
//! body no strain.

use super::findings::{body, places_of};
use crate::errors::{Finding, finding, number, quoted};
use crate::joints::End;
use crate::model::{Body, Capability, IndexedModel, Probe, Quantity, joints_of, loads_of};

pub(crate) fn capabilities(model: &IndexedModel<'_>) -> Vec<Finding> {
    let joints = joints_of(model).flat_map(|(path, joint)| {
        let (a, b) = joint.ends();
        let [of_a, of_b] = joint.kind().needs();
        let b = if let End::Place(b) = b { Some((format!("{path}.b"), b, of_b)) } else { None };
        let ends = [(format!("{path}.a"), a, of_a)].into_iter().chain(b);
        ends.filter_map(|(path, place, expected)| {
            let (capability, what) = expected?;
            rule(model, format!("{path}.body"), &place.body, &capability, what)
        })
        .collect::<Vec<_>>()
    });
    let loads = loads_of(model).filter_map(|(path, load)| {
        let (capability, what) = load.kind().needs()?;
        let (key, name) = match (load.on(), load.kind().along()) {
            (Some(place), _) => ("on.body", place.body.as_str()),
            (None, Some(part)) => ("body", part.body),
            (None, None) => return None,
        };
        rule(model, format!("{path}.{key}"), name, &capability, what)
    });
    let probes = model.probes.iter().enumerate().flat_map(|(i, probe)| {
        let path = format!("probes[{i}].on");
        let of = |quantity: &Quantity| match quantity {
            Quantity::Motion => None,
            Quantity::Rotation => Some((Capability::Section, "a rotation")),
            Quantity::InertialSensor => Some((Capability::Section, "an inertial sensor")),
            Quantity::SectionForces => Some((Capability::Strain, "section forces")),
            Quantity::Strain => Some((Capability::Strain, "strain")),
            Quantity::Stress => Some((Capability::Strain, "stress")),
            Quantity::Resultants => Some((Capability::Surface, "resultants")),
            Quantity::SurfaceStress => Some((Capability::Surface, "surface stress")),
        };
        let rules = probe.record.iter().filter_map(of);
        rules
            .filter_map(|(capability, what)| {
                rule(model, format!("{path}.body"), &probe.on.body, &capability, what)
            })
            .collect::<Vec<_>>()
    });
    joints.chain(loads).chain(probes).chain(arms(model)).chain(section_points(model)).collect()
}

fn rule(
    model: &IndexedModel<'_>,
    path: String,
    name: &str,
    capability: &Capability,
    what: &str,
) -> Option<Finding> {
    let (_, body) = model.named(name)?;
    let (found, expected) = match (body, capability) {
        (Body::Cable(_), Capability::Section | Capability::DrivenSection) => {
            (format!("{what} of a cable, which has no section to turn"), "a beam or a rigid body")
        }
        (Body::Mass(_), Capability::Direction) => (
            format!("{what} of a point mass, which has no directions"),
            "a \"spherical\" joint, or another body",
        ),
        (Body::Mass(_), Capability::Section | Capability::DrivenSection) => {
            (format!("{what} of a point mass, which has no directions"), "a beam or a rigid body")
        }
        (Body::Rigid(_), Capability::DrivenSection) => {
            (format!("{what} that clamps a rigid body"), "a beam, or a driven \"revolute\" joint")
        }
        (Body::Shell(_) | Body::ShearShell(_), Capability::Strain) => (
            format!("{what} of {}, a shell", quoted(body.name())),
            "a beam or a cable; of shells, record \"resultants\" or \"surface_stress\"",
        ),
        (Body::Beam(_) | Body::Cable(_) | Body::Rigid(_) | Body::Mass(_), Capability::Surface) => {
            (format!("{what} of {}, which is no shell", quoted(body.name())), "a shell")
        }
        (Body::Rigid(_) | Body::Mass(_), Capability::Strain) => {
            (format!("{what} of {}, which is rigid", quoted(body.name())), "a beam or a cable")
        }
        _ => return None,
    };
    Some(finding(path, found, expected).rests_on(["bodies".into()]))
}

/// Checks that arms are attached to sections or rigid bodies.
fn arms(model: &IndexedModel<'_>) -> Vec<Finding> {
    let armed = places_of(model).filter(|(_, place)| place.offset != [0.0; 3]);
    let unfit = armed.filter_map(|(path, place)| match body(model, place)?.1 {
        Body::Beam(_) | Body::Shell(_) | Body::ShearShell(_) | Body::Rigid(_) => None,
        Body::Cable(_) | Body::Mass(_) => {
            let error = finding(
                format!("{path}.offset"),
                "an arm on a body without sections",
                "a beam or a rigid body",
            );
            Some(error.rests_on(["bodies".into()]))
        }
    });
    unfit.collect()
}

/// Checks that points of sections are on bodies with sections, and that strains and stresses are those of points of the material.
fn section_points(model: &IndexedModel<'_>) -> Vec<Finding> {
    let probes = model.probes.iter().enumerate().filter(|(_, probe)| probe.offset != [0.0; 2]);
    let unfit = probes.filter_map(|(i, probe)| {
        let body = body(model, &probe.on)?.1;
        let (found, expected) = match body {
            Body::Beam(_) => return outside(model, i, probe, body),
            Body::Cable(_) => (
                "an offset on a cable",
                "no offset: the strain of a cable is that of its axis; \"section_forces\" contain its bending moment",
            ),
            Body::Shell(_) | Body::ShearShell(_) => {
                ("an offset on a shell", "no offset: a shell has no cross-section; `on.offset` is an arm")
            }
            Body::Rigid(_) => (
                "an offset on a rigid body",
                "no offset: a rigid body has no cross-section; `on.offset` is an arm",
            ),
            Body::Mass(_) => ("an offset on a point mass", "no offset: a point mass has no cross-section"),
        };
        Some(finding(format!("probes[{i}].offset"), found, expected).rests_on(["bodies".into()]))
    });
    unfit.collect()
}

/// Checks that a point at which strains or stresses are recorded is in the section, if the geometry of the section is known.
fn outside(model: &IndexedModel<'_>, i: usize, probe: &Probe, body: &Body) -> Option<Finding> {
    let is_local = |quantity: &Quantity| matches!(quantity, Quantity::Strain | Quantity::Stress);
    let what = probe.record.iter().copied().find(is_local)?;
    let Body::Beam(beam) = body else { return None };
    if [Some(&beam.section), beam.section_end.as_ref()]
        .into_iter()
        .flatten()
        .any(|name| !model.sections.contains_key(name))
    {
        return None;
    }
    let section = model.section_at(body, body.arc_length(&probe.on.at) / body.length())?;
    section.shape().points()?;
    let place = section.shape().outline().place_outside(probe.offset)?;
    let quantity = if what == Quantity::Strain { "strain" } else { "stress" };
    let found = format!("the {quantity} at [{}], {place}", probe.offset.map(number).join(", "));
    let path = format!("probes[{i}].offset");
    let error = finding(path, found, "a point (y, z) of the section, in the unit of length of the model");
    Some(error.rests_on(["bodies".into(), "sections".into()]))
}
