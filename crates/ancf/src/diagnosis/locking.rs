use super::free_motion::number;
use crate::model::{Beam, Body, ElementNodes, MaterialLaw, Model, ShearShell};

/// Smallest relative error of a stiffness or deflection that is reported.
const REPORTED: f64 = 0.01;

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
pub(crate) fn locking_warnings(model: &Model) -> Vec<String> {
    let beams =
        model.bodies.iter().filter_map(|body| if let Body::Beam(beam) = body { Some(beam) } else { None });
    let shells = model.bodies.iter().filter_map(|body| match body {
        Body::ShearShell(shell) => triangle_warning(shell),
        _ => None,
    });
    beams.flat_map(|beam| warnings(model, beam)).chain(shells).collect()
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

fn warnings(model: &Model, beam: &Beam) -> Vec<String> {
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
    if found.is_empty() {
        return Vec::new();
    }
    let formulation = beam.formulation.name();
    vec![format!(
        "beam `{name}`, formulation \"{formulation}\": {}; \"linked\" and \"quadratic\" have no such error",
        found.join("; ")
    )]
}
