//! Checks of shells, and refusal of what they do not support.

use nalgebra::Vector3;

use super::{fields, laminates, meshes};
use crate::errors::{Finding, finding, number, quoted};
use crate::joints::{ClampedGradients, End, Joint};
use crate::loads::Load;
use crate::model::{
    Analysis, At, Body, IndexedModel, Layup, Membrane, Modes, Place, Shell, ShellSurface, SurfaceGeometry,
    joints_of, loads_of, shear_shells_of, shells_of,
};

/// Largest angle of an element of a surface of revolution. Beyond it, the interpolated surface differs from it by more than 0.1 %.
const LARGEST_ANGLE: f64 = 0.79;
/// Sine of the angle of the lines of a surface below which it is degenerate, and the relative length of their tangents.
const DEGENERATE: f64 = 1e-3;
/// Distance of a place from a node, in elements, that counts as rounding.
const ON_NODE: f64 = 1e-9;

/// Checks that materials exist, that surfaces are regular, and that joints act on nodes.
pub(crate) fn shells(model: &IndexedModel<'_>) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, shell) in shells_of(model) {
        let layup = shell.layup();
        findings.extend(rule_of_material(model, &path, layup));
        let surface = rule_of_surface(&path, shell);
        findings.extend(fields::of_patch(&path, shell, surface.is_none()));
        findings.extend(surface);
        findings.extend(laminates::rule_of_axis(&path, shell));
        findings.extend(laminates::layers(model, &path, layup));
        findings.extend(rule_of_membrane(model, &path, (shell.membrane.as_ref(), layup)));
    }
    for (path, shell) in shear_shells_of(model) {
        let layup = shell.layup();
        findings.extend(rule_of_material(model, &path, layup));
        findings.extend(rule_of_membrane(model, &path, (shell.membrane.as_ref(), layup)));
        findings.extend(laminates::layers(model, &path, layup));
        findings.extend(meshes::rules(model, &path, (shell, layup)));
    }
    findings.extend(laminates::materials(model));
    if !model.has_shells() {
        return findings;
    }
    findings.extend(joints_of(model).flat_map(|(path, joint)| rules_of_joint(model, &path, joint)));
    findings.extend(loads_of(model).filter_map(|(path, load)| rule_of_load(model, &path, load)));
    findings.extend(rules_of_probes(model));
    findings.extend(rules_of_contacts(model));
    findings.extend(rule_of_errors(model));
    findings
}

/// Checks that a shell with a law of the membrane has one isotropic material, and a tension field if it states the slack.
fn rule_of_membrane(
    model: &IndexedModel<'_>,
    path: &str,
    (membrane, layup): (Option<&Membrane>, Layup<'_>),
) -> Option<Finding> {
    let membrane = membrane?;
    if !membrane.tension_field && membrane.slack != Membrane::default().slack {
        let found = format!("{} without a tension field", number(membrane.slack));
        let path = format!("{path}.membrane");
        let error = finding(format!("{path}.slack"), found, "`tension_field = true`, or no key `slack`");
        return Some(error.rests_on([format!("{path}.tension_field")]));
    }
    let is_orthotropic =
        model.materials.get(layup.material).is_some_and(|material| material.orthotropic.is_some());
    let (found, owner) = if !layup.layers.is_empty() {
        ("a law of the membrane of a laminate", format!("{path}.layers"))
    } else if is_orthotropic {
        ("a law of the membrane of an orthotropic material", "materials".into())
    } else {
        return None;
    };
    let expected = "no key `membrane`, or one isotropic material";
    Some(finding(format!("{path}.membrane"), found, expected).rests_on([owner]))
}

/// Checks that errors of modes with shells are estimated without damping only.
fn rule_of_errors(model: &IndexedModel<'_>) -> Option<Finding> {
    let found = match &model.analysis {
        _ if !model.output.errors => return None,
        Analysis::Modes(Modes { damped: true, .. }) => "true for damped modes with a shell",
        _ => return None,
    };
    let expected = "false: with shells, errors are estimated in statics, motions, undamped modes and buckling; compare with a finer mesh";
    Some(finding("output.errors".into(), found, expected).rests_on(["analysis".into(), "bodies".into()]))
}

fn rule_of_material(model: &IndexedModel<'_>, path: &str, shell: Layup<'_>) -> Option<Finding> {
    let key = format!("{path}.material");
    let Some(material) = model.materials.get(shell.material) else {
        let expected = "the name of a material, a key of `materials`";
        return Some(finding(key, quoted(shell.material), expected).rests_on(["materials".into()]));
    };
    let [found, expected] = laminates::unsupported(material)?;
    Some(finding(key, found, expected).rests_on(["materials".into()]))
}

/// Checks that the surface is regular, and that its elements are not too large for its curvature.
fn rule_of_surface(path: &str, shell: &Shell) -> Option<Finding> {
    if let Some(error) = rule_of_points(path, shell) {
        return Some(error);
    }
    let [n, m] = shell.elements.map(|count| count.min(64) as usize);
    let places = (0..=2 * n)
        .flat_map(|i| (0..=2 * m).map(move |j| [i as f64 / (2 * n) as f64, j as f64 / (2 * m) as f64]));
    let places: Vec<[f64; 2]> = places.collect();
    let geometry = shell.geometry();
    let lengths = |k: usize| places.iter().map(|at| geometry.map(*at)[k].norm()).fold(0.0, f64::max);
    let largest = [lengths(1), lengths(2)];
    let is_regular = |at: &[f64; 2]| {
        let [_, a, b, _] = geometry.map(*at);
        let sine = a.cross(&b).norm() / (a.norm() * b.norm());
        sine > DEGENERATE && a.norm() > DEGENERATE * largest[0] && b.norm() > DEGENERATE * largest[1]
    };
    if let Some([u, v]) = places.iter().find(|at| !is_regular(at)) {
        let element = [u * f64::from(shell.elements[0]), v * f64::from(shell.elements[1])];
        let found = format!(
            "a surface without normal at [u, v] = [{}, {}], element {}, {}",
            number(*u),
            number(*v),
            number(element[0].floor() + 1.0),
            number(element[1].floor() + 1.0)
        );
        let expected = "a surface whose lines along u and v have lengths above 0 and different directions";
        return Some(finding(format!("{path}.surface"), found, expected));
    }
    if let ShellSurface::Sphere { center, equator, axis, .. } = &shell.surface {
        let radius = Vector3::from(*equator) - Vector3::from(*center);
        let cosine = radius.normalize().dot(&Vector3::from(*axis).normalize());
        if cosine.abs() > 1e-9 {
            let expected = "a direction normal to that from `center` to `equator`";
            return Some(finding(format!("{path}.surface.axis"), "a direction that is not normal", expected));
        }
    }
    if let ShellSurface::Twisted { from, to, width, .. } = &shell.surface {
        let axis = (Vector3::from(*to) - Vector3::from(*from)).normalize();
        if Vector3::from(*width).normalize().dot(&axis).abs() > 1e-9 {
            let expected = "a vector normal to the axis";
            return Some(finding(format!("{path}.surface.width"), "a vector that is not normal", expected));
        }
    }
    let angles = match &shell.surface {
        ShellSurface::Flat { .. } => [0.0; 2],
        ShellSurface::Revolved { angle, .. } => [*angle, 0.0],
        ShellSurface::Sphere { angle, latitudes, .. } => [*angle, latitudes[1] - latitudes[0]],
        ShellSurface::Twisted { twist, .. } => [*twist, 0.0],
        ShellSurface::Lofted { .. } | ShellSurface::Swept { .. } => turns(shell, &geometry),
    };
    (0..2).find_map(|k| {
        let least = (angles[k].abs() / LARGEST_ANGLE).ceil();
        (f64::from(shell.elements[k]) < least).then(|| {
            let expected =
                format!("at least {}, so that an element turns by at most 45 degrees", number(least));
            finding(format!("{path}.elements[{k}]"), number(f64::from(shell.elements[k])), expected)
                .rests_on([format!("{path}.surface")])
        })
    })
}

/// Checks that all curves of a surface have the same number of points.
fn rule_of_points(path: &str, shell: &Shell) -> Option<Finding> {
    let ShellSurface::Lofted { sections } = &shell.surface else { return None };
    let count = sections.first()?.len();
    let k = sections.iter().position(|section| section.len() != count)?;
    let found = format!("{} points", sections[k].len());
    let expected = format!("{count} points, as in the first curve");
    Some(finding(format!("{path}.surface.sections[{k}]"), found, expected))
}

/// Angles by which the lines along u and v turn, for the largest turn of an element.
fn turns(shell: &Shell, geometry: &SurfaceGeometry<'_>) -> [f64; 2] {
    /// Parts of an element.
    const PARTS: u32 = 4;
    [0, 1].map(|k| {
        let [own, other] = [shell.elements[k], shell.elements[1 - k]].map(|count| count.min(64));
        let tangent = |i: u32, j: u32| {
            let [along, across] =
                [f64::from(i) / f64::from(own * PARTS), f64::from(j) / f64::from(2 * other)];
            geometry.map(if k == 0 { [along, across] } else { [across, along] })[k + 1]
        };
        let of_element = |element: u32, j: u32| -> f64 {
            (element * PARTS..(element + 1) * PARTS).map(|i| tangent(i, j).angle(&tangent(i + 1, j))).sum()
        };
        let elements = (0..own).flat_map(|element| (0..=2 * other).map(move |j| (element, j)));
        f64::from(own) * elements.map(|(element, j)| of_element(element, j)).fold(0.0, f64::max)
    })
}

/// True for a place on a shell of either kind.
fn is_on_shell(model: &IndexedModel<'_>, place: &Place) -> bool {
    model.named(&place.body).is_some_and(|(_, body)| body.is_shell())
}

/// Thin shell of a place.
fn shell_of<'m>(model: &IndexedModel<'m>, place: &Place) -> Option<&'m Shell> {
    match model.named(&place.body)?.1 {
        Body::Shell(shell) => Some(shell),
        _ => None,
    }
}

/// Checks that joints act on edges of shells only if they are supports or seams, and that at most one end of a joint is between the
/// nodes of a thin shell.
fn rules_of_joint(model: &IndexedModel<'_>, path: &str, joint: &Joint) -> Vec<Finding> {
    let (a, b) = joint.ends();
    let b = if let End::Place(b) = b { Some(("b", b)) } else { None };
    let ends = [("a", a)].into_iter().chain(b);
    let of_end = |(end, place): (&str, &Place)| {
        if !is_on_shell(model, place) {
            return None;
        }
        let all = match joint {
            Joint::Clamp(clamp) => clamp.fix == Some(ClampedGradients::All),
            Joint::Drive(drive) => drive.fix == Some(ClampedGradients::All),
            _ => false,
        };
        if all {
            let expected = "\"section\": the frame of a shell follows its tangents or its director";
            return Some(finding(format!("{path}.fix"), "\"all\" on a shell", expected));
        }
        let expected = "a point; edges have joints of kind \"support\" and \"seam\"";
        (matches!(place.at, At::Edge(_)) && !joint.kind().is_distributed())
            .then(|| finding(format!("{path}.{end}.at"), "an edge", expected))
    };
    let mut findings: Vec<Finding> = ends.clone().filter_map(of_end).collect();
    if joint.kind().is_distributed() {
        return findings;
    }
    // The coordinates of two elements are all that an equation can have.
    if let (Some(_), Some(second)) = (between_nodes(model, a), b.and_then(|(_, b)| between_nodes(model, b))) {
        let expected = "a node of one of both shells: multiples of 1/n and 1/m for n x m elements";
        findings.push(finding(format!("{path}.b.at"), second, expected).rests_on(["bodies".into()]));
    }
    findings
}

/// Description of a place between the nodes of a thin shell; `None` for other places.
fn between_nodes(model: &IndexedModel<'_>, place: &Place) -> Option<String> {
    let (shell, at) = (shell_of(model, place)?, place.at.on_surface()?);
    let is_off = |k: usize| {
        let x = at[k] * f64::from(shell.elements[k]);
        (x - x.round()).abs() > ON_NODE
    };
    (is_off(0) || is_off(1))
        .then(|| format!("[{}, {}], between nodes as the place `a`", number(at[0]), number(at[1])))
}

/// Checks that point loads act on points of shells, and loads of shells on shells.
fn rule_of_load(model: &IndexedModel<'_>, path: &str, load: &Load) -> Option<Finding> {
    let place = load.on().filter(|place| is_on_shell(model, place))?;
    let expected = "a point; edges have loads of kind \"edge_force\" and \"edge_moment\"";
    matches!(place.at, At::Edge(_)).then(|| finding(format!("{path}.on.at"), "an edge", expected))
}

fn rules_of_probes(model: &IndexedModel<'_>) -> Vec<Finding> {
    let probes = model.probes.iter().enumerate();
    let on_shells = probes.filter(|(_, probe)| is_on_shell(model, &probe.on));
    let rule = |(i, probe): (usize, &crate::model::Probe)| {
        let path = format!("probes[{i}]");
        matches!(probe.on.at, At::Edge(_)).then(|| finding(format!("{path}.on.at"), "an edge", "a point"))
    };
    on_shells.filter_map(rule).collect()
}

/// Rejects obstacles on shells, and open lists of bodies in contact with each other in models with a shell and a rigid body with a surface.
fn rules_of_contacts(model: &IndexedModel<'_>) -> Vec<Finding> {
    let contacts = model.contacts.iter().enumerate();
    let rule = |(i, contact): (usize, &crate::model::Contact)| {
        let path = format!("contacts[{i}]");
        if contact.with.on().is_some_and(|place| is_on_shell(model, place)) {
            let expected = "a beam, a rigid body or the ground: a shell carries no obstacle";
            return Some(
                finding(format!("{path}.with.on.body"), "a shell", expected).rests_on(["bodies".into()]),
            );
        }
        let other = "a rigid body with a `surface`";
        let has_other = model.bodies.iter().any(|body| body.surface().is_some());
        let is_open = contact.bodies.is_empty() && contact.with.obstacle().is_none();
        (is_open && has_other).then(|| {
            let expected = format!("the names of the bodies in contact: {other} touches obstacles only");
            let found = format!("no `bodies` in a model with a shell and {other}");
            let error = finding(path, found, expected);
            Finding { absence: true, ..error.rests_on(["bodies".into()]) }
        })
    };
    contacts.filter_map(rule).collect()
}
