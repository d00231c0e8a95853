//! Checks of orthotropic materials and of the layers of shells.

use crate::errors::{Finding, finding, number, quoted};
use crate::model::{
    IndexedModel, Layup, Material, MaterialLaw, Orthotropic, Shell, bodies_of, no_projection,
};
use crate::schema::unknown;

/// Largest difference of the sum of the thicknesses of layers from that of the shell, relative to it.
const SUM: f64 = 1e-9;

/// Checks that orthotropic materials have a positive strain energy, and that only shells have them.
pub(super) fn materials(model: &IndexedModel<'_>) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (name, material) in &model.materials {
        let Some(Orthotropic { young, .. }) = material.orthotropic else { continue };
        let limit = (material.young / young).sqrt();
        let path = format!("materials.{name}");
        if material.poisson.abs() >= limit {
            let expected = format!(
                "a number between -{0} and {0}, the square root of the ratio of Young's moduli along and transverse to the fibres",
                number(limit)
            );
            let error = finding(format!("{path}.poisson"), number(material.poisson), expected);
            findings.push(error.rests_on([format!("{path}.young"), format!("{path}.orthotropic")]));
        }
        if material.law == MaterialLaw::NeoHookean {
            let expected = "\"st_venant_kirchhoff\" for an orthotropic material";
            findings.push(finding(format!("{path}.law"), "\"neo_hookean\"", expected));
        }
    }
    for (path, body) in bodies_of(model) {
        let material = body.section_and_material().and_then(|(_, name)| model.materials.get(name));
        if material.is_some_and(|material| material.orthotropic.is_some()) {
            let expected = "an isotropic one: only shells have orthotropic materials";
            let error = finding(format!("{path}.material"), "an orthotropic material", expected);
            findings.push(error.rests_on(["materials".into()]));
        }
    }
    findings
}

/// Checks the layers of a shell of either kind and their materials.
pub(super) fn layers(model: &IndexedModel<'_>, path: &str, layup: Layup<'_>) -> Vec<Finding> {
    let mut findings: Vec<Finding> = rule_of_thicknesses(path, layup).into_iter().collect();
    let first = model.materials.get(layup.plies()[0].0);
    for (k, layer) in layup.layers.iter().enumerate() {
        let Some(name) = &layer.material else { continue };
        let key = format!("{path}.layers[{k}].material");
        let Some(material) = model.materials.get(name) else {
            let names = model.materials.keys().map(String::as_str).collect();
            findings.push(unknown(key, "material", name, names).rests_on(["materials".into()]));
            continue;
        };
        findings.extend(rule_of_layer(key, name, material, first));
    }
    findings
}

/// Returns what shells do not support of a material, with what is expected.
pub(super) fn unsupported(material: &Material) -> Option<[&'static str; 2]> {
    if material.law == MaterialLaw::NeoHookean {
        return Some(["a neo-Hookean material of a shell", "one whose law is \"st_venant_kirchhoff\""]);
    }
    let found = "a material of a shell with retardation times by kind of deformation";
    material.damping.is_by_kind().then_some([found, "one with `damping.strain` alone"])
}

fn rule_of_layer(key: String, name: &str, material: &Material, first: Option<&Material>) -> Option<Finding> {
    if let Some([found, expected]) = unsupported(material) {
        return Some(finding(key, found, expected).rests_on(["materials".into()]));
    }
    first.is_some_and(|first| first.damping != material.damping).then(|| {
        let expected = "the damping of the first layer: a shell has one `damping`";
        finding(key, format!("{}, whose `damping` differs", quoted(name)), expected)
            .rests_on(["materials".into()])
    })
}

/// Checks that either no layer or all layers have a thickness, with the sum of the shell.
fn rule_of_thicknesses(path: &str, shell: Layup<'_>) -> Option<Finding> {
    let given = shell.layers.iter().filter_map(|layer| layer.thickness);
    let (count, sum) = (given.clone().count(), given.sum::<f64>());
    if count == 0 || (shell.varies && count == shell.layers.len()) {
        return None;
    }
    let [found, expected] = if count < shell.layers.len() {
        let found = format!("{count} of {} layers with a thickness", shell.layers.len());
        [found, "a thickness of all layers, or of none for equal ones".to_owned()]
    } else if (sum - shell.thickness).abs() > SUM * shell.thickness {
        let expected = format!("the thickness {} of the shell", number(shell.thickness));
        [format!("layers with the sum {} of thicknesses", number(sum)), expected]
    } else {
        return None;
    };
    Some(finding(format!("{path}.layers"), found, expected).rests_on([format!("{path}.thickness")]))
}

/// Checks that the axis has a projection on the surface everywhere.
pub(super) fn rule_of_axis(path: &str, shell: &Shell) -> Option<Finding> {
    let surface = format!("{path}.surface");
    let axis = shell.fibre_axis.as_ref()?.uniform()?;
    no_projection(format!("{path}.fibre_axis"), axis, |axis| shell.normal_along(axis), surface)
}
