//! Checks of bodies beyond the schema.

use ancf_mechanics::elements::is_physical_inertia;
use nalgebra::Vector3;

use super::findings::COINCIDENT;
use crate::errors::{Finding, finding, is_direction, no_direction, number};
use crate::model::{Beam, Body, IndexedModel, MaterialLaw, Shape, beams_of, bodies_of};
use crate::schema::unknown;

/// Checks that sections and materials exist, that the axis is a curve, and that `up` is not parallel to it.
pub(crate) fn bodies(model: &IndexedModel<'_>) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, body) in bodies_of(model) {
        let sections = || model.sections.keys().map(String::as_str).collect();
        let materials = || model.materials.keys().map(String::as_str).collect();
        let Some((section, material)) = body.section_and_material() else {
            findings.extend(rule_of_inertia(&path, body));
            findings.extend(rule_of_axial_motion(&path, body));
            findings.extend(rule_of_spin(&path, body));
            continue;
        };
        if !model.sections.contains_key(section) {
            let error = unknown(format!("{path}.section"), "section", section, sections());
            findings.push(error.rests_on(["sections".into()]));
        }
        if let Body::Beam(Beam { section_end: Some(end), .. }) = body
            && !model.sections.contains_key(end)
        {
            let error = unknown(format!("{path}.section_end"), "section", end, sections());
            findings.push(error.rests_on(["sections".into()]));
        }
        if !model.materials.contains_key(material) {
            let error = unknown(format!("{path}.material"), "material", material, materials());
            findings.push(error.rests_on(["materials".into()]));
        }
        findings.extend(rule_of_axis(&path, body));
    }
    findings
}

/// Checks that the moments of inertia are physical: none exceeds the sum of the others.
fn rule_of_inertia(path: &str, body: &Body) -> Option<Finding> {
    let Body::Rigid(rigid) = body else { return None };
    (!is_physical_inertia(&rigid.tensor())).then(|| {
        let expected = "principal moments above 0, none larger than the sum of the other two";
        let listed = rigid.inertia.map(number).join(", ");
        finding(format!("{path}.inertia"), format!("[{listed}]"), expected)
            .rests_on([format!("{path}.products")])
    })
}

/// Checks that bodies without an axis have no motion along it.
fn rule_of_axial_motion(path: &str, body: &Body) -> Option<Finding> {
    let axial = body.motion().axial;
    (axial != 0.0).then(|| {
        let expected = "0 for a body without an axis: `velocity` is that of its centre";
        finding(format!("{path}.motion.axial"), number(axial), expected)
    })
}

/// Checks that point masses have no rotation.
fn rule_of_spin(path: &str, body: &Body) -> Option<Finding> {
    let spin = body.motion().spin;
    (matches!(body, Body::Mass(_)) && spin != [0.0; 3]).then(|| {
        let found = format!("[{}] of a point mass", spin.map(number).join(", "));
        finding(format!("{path}.motion.spin"), found, "no rotation of a point mass: state its `velocity`")
    })
}

fn rule_of_axis(path: &str, body: &Body) -> Option<Finding> {
    let axis = [format!("{path}.from"), format!("{path}.to"), format!("{path}.shape")];
    let [from, to] = body.span().map(Vector3::from);
    let (straight, shape) = match body {
        Body::Beam(beam) => (beam.shape.is_straight(), Some(&beam.shape)),
        Body::Cable(_) | Body::Shell(_) | Body::ShearShell(_) | Body::Rigid(_) | Body::Mass(_) => {
            (true, None)
        }
    };
    let up = match body {
        Body::Beam(beam) => beam.up,
        Body::Cable(cable) => cable.up,
        Body::Shell(_) | Body::ShearShell(_) | Body::Rigid(_) | Body::Mass(_) => None,
    };
    match (body.curve(), up) {
        (None, _) if straight && from == to => {
            let error =
                finding(format!("{path}.to"), "a beam of length 0", "an end of the axis away from its start");
            Some(error.rests_on(axis))
        }
        (None, _) if straight => Some(
            finding(format!("{path}.to"), "an axis too long for its length to be a number", "a shorter one")
                .rests_on(axis),
        ),
        (None, _) => Some(no_curve(path, shape?).rests_on(axis)),
        (Some(curve), _) if !curve.length().is_finite() => Some(
            finding(
                format!("{path}.shape"),
                "an axis too long for its length to be a number",
                "a shorter one",
            )
            .rests_on(axis),
        ),
        (Some(_), Some(up)) if !is_direction(up) => Some(no_direction(format!("{path}.up"), up)),
        (Some(_), Some(_)) if body.up().is_none() => {
            Some(finding(format!("{path}.up"), "a direction along the axis", "one across it").rests_on(axis))
        }
        (Some(curve), _) => rule_of_end(path, &(from + curve.at(curve.length()).0), &to, curve.length())
            .map(|e| e.rests_on(axis)),
    }
}

fn no_curve(path: &str, shape: &Shape) -> Finding {
    match shape {
        Shape::Arc { .. } => finding(
            format!("{path}.shape.through"),
            "three points on a line",
            "a point off the line from start to end",
        ),
        Shape::Helix { .. } => finding(
            format!("{path}.shape"),
            "a helix without radius or axis",
            "a start away from the axis, and a direction",
        ),
        Shape::Spline { .. } | Shape::Straight => {
            finding(format!("{path}.shape.through"), "a point twice in a row", "points away from each other")
        }
    }
}

/// Checks that a helix ends at the end of the body.
fn rule_of_end(path: &str, end: &Vector3<f64>, to: &Vector3<f64>, length: f64) -> Option<Finding> {
    ((end - to).norm() > COINCIDENT * length).then(|| {
        let at = |r: &Vector3<f64>| format!("[{}, {}, {}]", number(r.x), number(r.y), number(r.z));
        finding(format!("{path}.to"), at(to), format!("{}, where the helix ends", at(end)))
    })
}

/// Checks that the bending stiffness of a cable is equal about all transverse axes.
pub(crate) fn cables(model: &IndexedModel<'_>) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, body) in bodies_of(model) {
        let Body::Cable(cable) = body else { continue };
        let Some(section) = model.sections.get(&cable.section) else { continue };
        let m = section.moments();
        if (m.yy - m.zz).abs() > 1e-9 * m.yy.max(m.zz) {
            let error = finding(
                format!("{path}.section"),
                "a section that bends differently about y and z",
                "a circle, a tube, a square or a general section with iy = iz",
            );
            findings.push(error.rests_on(["sections".into()]));
        }
        if model
            .materials
            .get(&cable.material)
            .is_some_and(|material| material.law == MaterialLaw::NeoHookean)
        {
            let error = finding(
                format!("{path}.material"),
                "a neo-Hookean material of a cable",
                "one whose law is \"st_venant_kirchhoff\"",
            );
            findings.push(error.rests_on(["materials".into()]));
        }
    }
    findings
}

/// Rejects materials and sections that a formulation does not support.
pub(crate) fn formulations(model: &IndexedModel<'_>) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, beam) in beams_of(model) {
        let material = model.materials.get(&beam.material);
        if !beam.formulation.is_continuum() && material.is_some_and(|m| m.law == MaterialLaw::NeoHookean) {
            let expected = "\"continuum\", which alone integrates a neo-Hookean law over the section";
            let error = finding(
                format!("{path}.formulation"),
                "a rod's elasticity of a neo-Hookean material",
                expected,
            );
            findings.push(Finding {
                absence: true,
                ..error.rests_on([format!("{path}.material"), "materials".into()])
            });
        }
        if beam.formulation.is_continuum() && material.is_some_and(|m| m.damping.is_by_kind()) {
            let expected =
                "a rod's formulation, or `damping.strain` alone: a continuum has one retardation time";
            let error = finding(
                format!("{path}.formulation"),
                "\"continuum\" with retardation times by kind",
                expected,
            );
            findings.push(Finding {
                absence: true,
                ..error.rests_on([format!("{path}.material"), "materials".into()])
            });
        }
        if let (Some(start), Some(end)) = (
            model.sections.get(&beam.section),
            beam.section_end.as_ref().and_then(|end| model.sections.get(end)),
        ) && start.towards(end, 1.0).is_none()
        {
            let error = finding(
                format!("{path}.section_end"),
                "a section of another kind",
                "one of the kind of `section`",
            );
            findings.push(error.rests_on([format!("{path}.section"), "sections".into()]));
        }
    }
    findings
}
