use ancf_mechanics::sections::Moments;
use nalgebra::Vector3;

use super::free_motion::number;
use crate::model::{Beam, Body, ElementNodes, MaterialLaw, Model, ShearShell};

/// Smallest relative error of a stiffness or deflection that is reported.
const REPORTED: f64 = 0.01;

/// Parts of an element in which its axis is sampled.
const PARTS: usize = 4;

/// Share of triangles in a mesh that is reported.
const TRIANGLES: f64 = 0.1;

/// Describes errors of beams that follow from the choice of their formulation, and of meshes of shells with many triangles, one
/// sentence each.
///
/// | error | factor | of |
/// |---|---|---|
/// | Poisson locking | (λ+2G)/E | bending stiffness of `continuum`, on any mesh |
/// | polar moment of area instead of J | (I_y+I_z)/J | torsional stiffness of `continuum`, on any mesh |
/// | shear locking | 1 − 1/(3n²) | deflection under the own weight, of n elements `continuum` or `enhanced` |
/// | [thickness locking](thickness_locking) | 1/(1 + λ) | deflection of curved elements `continuum` or `enhanced` |
pub(crate) fn locking_warnings(model: &Model) -> Vec<String> {
    let beams = model.bodies.iter().filter_map(|body| match body {
        Body::Beam(beam) => Some((body, beam)),
        _ => None,
    });
    let shells = model.bodies.iter().filter_map(|body| match body {
        Body::ShearShell(shell) => triangle_warning(shell),
        _ => None,
    });
    beams.flat_map(|(body, beam)| warnings(model, body, beam)).chain(shells).collect()
}

/// Describes a mesh whose triangles, with their constant membrane strains, determine its stiffness.
fn triangle_warning(shell: &ShearShell) -> Option<String> {
    let elements = &shell.mesh.elements;
    let triangles = elements.iter().filter(|element| matches!(element, ElementNodes::Triangle(_))).count();
    (triangles as f64 > TRIANGLES * elements.len() as f64).then(|| {
        format!(
            "shell `{}`: {triangles} of {} elements are triangles, which are too stiff for bending in their plane; quadrilaterals are not",
            shell.name,
            elements.len()
        )
    })
}

fn warnings(model: &Model, body: &Body, beam: &Beam) -> Vec<String> {
    let (Some(material), Some(section)) =
        (model.materials.get(&beam.material), model.sections.get(&beam.section))
    else {
        return Vec::new();
    };
    let (mut found, name) = (Vec::new(), &beam.name);
    if beam.formulation.is_continuum() {
        let (lame, moments) = (material.lame(), section.moments());
        let bending = (lame.lambda + 2.0 * lame.shear) / material.young;
        if bending > 1.0 + REPORTED {
            found.push(format!(
                "the bending stiffness is {} E I (Poisson locking, any mesh)",
                number(bending)
            ));
        }
        let torsion = (moments.yy + moments.zz) / section.torsion_constant();
        if (torsion - 1.0).abs() > REPORTED && material.law == MaterialLaw::StVenantKirchhoff {
            found.push(format!("the torsional stiffness is {} G J (no warping, any mesh)", number(torsion)));
        }
    }
    let shear = 1.0 / (3.0 * f64::from(beam.elements).powi(2));
    if beam.formulation.has_shear_locking() && shear > REPORTED {
        let (percent, n) = (number(100.0 * shear), beam.elements);
        found.push(format!("deflections are about {percent} % too small with {n} elements (shear locking)"));
    }
    let excess = thickness_locking(body, beam, &section.moments()).unwrap_or(0.0);
    if excess > REPORTED {
        let (percent, n) = (number(100.0 * excess / (1.0 + excess)), beam.elements);
        found.push(format!(
            "deflections are up to {percent} % too small with {n} curved elements (thickness locking)"
        ));
    }
    if found.is_empty() {
        return Vec::new();
    }
    let formulation = beam.formulation.name();
    vec![format!(
        "beam `{name}`, formulation \"{formulation}\": {}; \"linked\" and \"quadratic\" have no such error",
        found.join("; ")
    )]
}

/// Returns the relative excess λ of the bending stiffness of elements `continuum` and `enhanced` with a curved axis; `None` for others.
///
/// In pure bending the linearly interpolated r_y and r_z of a curved element deform the section by δκ κ l² (1 − 4η²)/4 and a constant, with the curvature
/// κ of the axis, the change δκ and η in [−½, ½]. The constant is free, and the rest has the energy of
///
/// λ = (κ l²)² A/(180 I)
///
/// in the plane of the curvature, and about half of it in the other one. It decreases with the fourth power of the length of the elements.
fn thickness_locking(body: &Body, beam: &Beam, moments: &Moments) -> Option<f64> {
    let curve = body.curve().filter(|_| beam.formulation.has_shear_locking() && !beam.shape.is_straight())?;
    let parts = PARTS * beam.elements as usize;
    let at: Vec<f64> = (0..=parts).map(|k| curve.length() * k as f64 / parts as f64).collect();
    let nodes = curve.nodes(body.up()?, beam.twist, &at);
    // Squares of the angle of an element about both axes of the section.
    let angles = nodes.windows(2).map(|ends| {
        let change: Vector3<f64> = (ends[1].frame[0] - ends[0].frame[0]) * PARTS as f64;
        [1, 2].map(|axis| change.dot(&ends[0].frame[axis]).powi(2))
    });
    let angles: Vec<[f64; 2]> = angles.collect();
    let length = curve.length() / f64::from(beam.elements);
    let scale = length * length * moments.area / 180.0;
    let excess = |element: &[[f64; 2]]| {
        let [y, z] =
            [0, 1].map(|axis| element.iter().map(|part| part[axis]).sum::<f64>() * scale / PARTS as f64);
        ((y + 0.5 * z) / moments.yy).max((z + 0.5 * y) / moments.zz)
    };
    Some(angles.chunks(PARTS).map(excess).fold(0.0, f64::max))
}
