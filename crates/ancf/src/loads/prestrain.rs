use ancf_mechanics::elements::Prestrain as MeshPrestrain;
use ancf_mechanics::functions::Function;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::parts::{AxisPart, LoadBuilder, LoadContext, LoadKind, end, start};
use crate::errors::{Finding, finding, number, quoted};
use crate::model::{At, Body, MaterialLaw, TimeFunction};
use crate::units::Scaled;

/// Change of the stress-free shape of a beam or cable: shrinking, heating, growing, pretension.
///
/// The stress follows from the strain less the prescribed one. Axial strain, tension and curvature of all loads of a body add up.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Prestrain {
    /// Name of the body.
    pub body: String,
    /// Start of the part, a node; the start of the axis by default.
    #[serde(default = "start")]
    pub from: At,
    /// End of the part, a node; the end of the axis by default.
    #[serde(default = "end")]
    pub to: At,
    /// Axial strain without stress: 0.01 lengthens a free body by 1 %, αΔT is that of a warmer body.
    #[serde(default)]
    #[schemars(range(min = -0.5, max = 1.0))]
    #[unit(number)]
    pub strain: f64,
    /// Axial strain at `to`. The strain varies linearly from `strain` at `from`. Constant by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = -0.5, max = 1.0))]
    #[unit(number)]
    pub strain_end: Option<f64>,
    /// Axial force in the reference shape, positive in tension; force.
    #[serde(default)]
    #[unit(force)]
    pub tension: f64,
    /// Curvature without stress in the frame of the section, in addition to that of the reference shape: twist about x, bending about y
    /// and z; radians/length.
    #[serde(default)]
    #[unit(radian / length)]
    pub curvature: [f64; 3],
    /// Curvature at `to`, radians/length. The curvature varies linearly from `curvature` at `from`. Constant by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[unit(radian / length)]
    pub curvature_end: Option<[f64; 3]>,
    /// Function of time that multiplies strain, tension and curvature. Statics ignores it, except the value of an input.
    #[serde(default)]
    pub time: TimeFunction,
}

impl LoadKind for Prestrain {
    fn noun(&self) -> &'static str {
        "prestrain"
    }

    /// Adds nothing: prescribed strains are part of the elements (the `source` method).
    fn build(&self, _builder: &mut LoadBuilder<'_>) {}

    fn bodies(&self) -> Vec<(String, &str)> {
        vec![("body".into(), &self.body)]
    }

    fn time(&self) -> Option<&TimeFunction> {
        Some(&self.time)
    }

    fn time_mut(&mut self) -> Option<&mut TimeFunction> {
        Some(&mut self.time)
    }

    /// Viscous stresses depend on the rate.
    fn uses_rates(&self) -> bool {
        true
    }

    fn is_known_within_elements(&self) -> bool {
        true
    }

    fn check(&self, path: &str, context: &dyn LoadContext) -> Vec<Finding> {
        let Some((owner, body)) = context.body(&self.body) else { return Vec::new() };
        let mut findings = self.part().check(path, context);
        if !findings.is_empty() || !body.is_flexible() || body.length() <= 0.0 {
            return findings;
        }
        findings.extend(self.check_nodes(path, &owner, body));
        findings.extend(self.check_material(path, &owner, body, context));
        findings
    }
}

/// Distance from a node that counts as rounding, relative to an element.
const AT_NODE: f64 = 1e-6;

impl Prestrain {
    fn part(&self) -> AxisPart<'_> {
        AxisPart { body: &self.body, from: &self.from, to: &self.to, loads: [[0.0; 3]; 2] }
    }

    /// Key of a curvature that is not zero.
    fn curvature_key(&self) -> Option<&'static str> {
        let keys = [("curvature", self.curvature), ("curvature_end", self.curvature_end.unwrap_or_default())];
        keys.into_iter().find(|(_, curvature)| *curvature != [0.0; 3]).map(|(key, _)| key)
    }

    /// Prescribed strains of the elements of a body. `rigidity` is EA, which is constant along a body with a tension.
    pub(crate) fn source(&self, body: &Body, rigidity: f64, function: Function) -> MeshPrestrain {
        let span = self.part().span(body);
        let strains = [self.strain, self.strain_end.unwrap_or(self.strain)];
        let curvatures = [self.curvature, self.curvature_end.unwrap_or(self.curvature)];
        let tension = stretched(body, self.tension / rigidity);
        MeshPrestrain {
            ends: span.ends,
            strain: strains.map(|strain| strain + tension),
            curvature: curvatures.map(Vector3::from),
            function,
        }
    }

    /// Checks that the part starts and ends at nodes.
    fn check_nodes(&self, path: &str, owner: &str, body: &Body) -> Vec<Finding> {
        let element = body.length() / f64::from(body.elements().max(1));
        let check = |(key, at): (&str, &At)| {
            let s = body.arc_length(at);
            let node = (s / element).round() * element;
            if (s - node).abs() <= AT_NODE * element {
                return None;
            }
            let found = format!("{}, between two nodes of {}", number(s), quoted(body.name()));
            let expected = format!("the arc length of a node, such as {}", number(node));
            let rests_on = ["elements", "from", "to", "shape"].map(|key| format!("{owner}.{key}"));
            Some(finding(format!("{path}.{key}"), found, expected).rests_on(rests_on))
        };
        [("from", &self.from), ("to", &self.to)].into_iter().filter_map(check).collect()
    }

    /// Checks that the law of the material has strains to prescribe, and that the tension has a strain.
    fn check_material(
        &self,
        path: &str,
        owner: &str,
        body: &Body,
        context: &dyn LoadContext,
    ) -> Vec<Finding> {
        let Some((_, name)) = body.section_and_material() else { return Vec::new() };
        let Some(material) = context.material(name) else { return Vec::new() };
        let mut findings = Vec::new();
        if let (Body::Cable(_), Some(key)) = (body, self.curvature_key()) {
            let found =
                format!("a curvature of {}, a cable, which has no section to turn", quoted(body.name()));
            let error = finding(format!("{path}.{key}"), found, "a beam");
            findings.push(error.rests_on([format!("{owner}.kind"), format!("{path}.body")]));
        }
        if material.law == MaterialLaw::NeoHookean {
            let found = format!("a prestrain of {}, which has a neo-Hookean material", quoted(body.name()));
            let error = finding(format!("{path}.body"), found, "a body of a St. Venant-Kirchhoff material");
            findings.push(error.rests_on([format!("{owner}.material"), "materials".into()]));
        }
        let rigidities = [0.0, 1.0].map(|part| rigidity(body, part, context));
        if let [Some(first), Some(last)] = rigidities
            && self.tension != 0.0
        {
            let rests_on = || [format!("{owner}.section"), "sections".into(), "materials".into()];
            if (first - last).abs() > AT_NODE * first {
                let found = format!("a tension of {}, which is tapered", quoted(body.name()));
                let expected = "`strain` and `strain_end`: the strain of a tension is not linear there";
                findings.push(finding(format!("{path}.tension"), found, expected).rests_on(rests_on()));
            } else if (self.tension / first).abs() > LARGEST {
                let found = format!("{} times EA", number(self.tension / first));
                let expected = format!("at most {} times EA = {}", number(LARGEST), number(first));
                findings.push(finding(format!("{path}.tension"), found, expected).rests_on(rests_on()));
            }
        }
        findings
    }
}

/// Largest tension, relative to EA.
const LARGEST: f64 = 0.25;

/// Axial rigidity EA at a fraction of the length.
pub(crate) fn rigidity(body: &Body, fraction: f64, context: &dyn LoadContext) -> Option<f64> {
    let (_, name) = body.section_and_material()?;
    let material = context.material(name)?;
    Some(material.young * context.section_at(body, fraction)?.cross_section(material.poisson).moments.area)
}

/// Strain without stress of a body with a tension in its reference shape, relative to EA.
///
/// N = EA (ε − ε⁰) of a cable, N = EA (ε + ½ε² − ε⁰ − ½ε⁰²) of a beam with ε = 0.
fn stretched(body: &Body, tension: f64) -> f64 {
    match body {
        Body::Cable(_) => -tension,
        _ => (1.0 - 2.0 * tension).sqrt() - 1.0,
    }
}
