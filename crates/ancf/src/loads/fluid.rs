use ancf_mechanics::fluid::HydroSection;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::parts::{LoadBuilder, LoadContext, LoadKind};
use crate::errors::{Finding, finding, quoted};
use crate::model::{Beam, Body, Section, TimeFunction, disk_area};
use crate::units::Scaled;

/// Fluid around bodies: drag, added mass and buoyancy.
///
/// The forces follow Morison's equation, with the coefficients of MoorDyn.
///
/// Source: Morison et al. (1950); Hall & Goupee (2015).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Fluid {
    /// Names of the bodies in the fluid.
    #[schemars(length(min = 1))]
    pub bodies: Vec<String>,
    /// Density ρ of the fluid, mass/volume.
    #[unit(mass / length^3)]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub density: f64,
    /// Uniform velocity of the fluid, length/time; at rest by default.
    #[serde(default)]
    #[unit(length / time)]
    pub current: [f64; 3],
    /// Function of time that multiplies the current. Statics ignores it, except the value of an input.
    #[serde(default)]
    pub time: TimeFunction,
    /// Diameter d exposed to the flow, length; the outer diameter of circles and tubes by default.
    #[unit(length)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub diameter: Option<f64>,
    /// Displaced area A of a section, length²; that of a circle of the diameter by default.
    #[unit(length^2)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub area: Option<f64>,
    /// Coefficients of drag across and along the axis: ½ρ d C_n |w_n| w_n and ½ρ π d C_t |w_t| w_t per length.
    #[unit(number)]
    #[schemars(inner(range(min = 0)))]
    pub drag: [f64; 2],
    /// Coefficients of added mass across and along the axis, in multiples of ρ A per length.
    #[serde(default = "cylinder")]
    #[unit(number)]
    #[schemars(inner(range(min = 0)))]
    pub added_mass: [f64; 2],
}

/// Coefficients of added mass of a circular cylinder in an ideal fluid.
fn cylinder() -> [f64; 2] {
    [1.0, 0.0]
}

impl Fluid {
    /// Fluid at rest around bodies, with coefficients of drag across and along the axis.
    pub fn still(bodies: &[&str], density: f64, drag: [f64; 2]) -> Self {
        Self {
            bodies: bodies.iter().map(|&name| name.to_owned()).collect(),
            density,
            current: [0.0; 3],
            time: TimeFunction::default(),
            diameter: None,
            area: None,
            drag,
            added_mass: cylinder(),
        }
    }

    /// Hydrodynamic properties of a section. `None` if the diameter is not stated and the section is not round.
    pub(crate) fn hull(&self, section: &Section) -> Option<HydroSection> {
        let shape = section.shape();
        let (diameter, displaced) = match self.diameter {
            Some(diameter) => (diameter, disk_area(0.5 * diameter)),
            None => (2.0 * shape.outer_radius()?, shape.displaced_area()?),
        };
        let area = self.area.unwrap_or(displaced);
        Some(HydroSection { diameter, area, drag: self.drag, added_mass: self.added_mass })
    }
}

impl LoadKind for Fluid {
    fn noun(&self) -> &'static str {
        "fluid"
    }

    fn build(&self, builder: &mut LoadBuilder<'_>) {
        let context = builder.context();
        let medium = builder.flow(self.density, self.current, &self.time);
        // Bodies in the order of the model, which is that of their coordinates.
        for name in builder.body_names().filter(|&name| self.bodies.iter().any(|own| own == name)) {
            let Some((body, mesh)) = builder.flexible(name) else { continue };
            let hull = |s: f64| {
                let section = context.section_at(body, s / mesh.length());
                let hull = section.and_then(|section| self.hull(&section));
                hull.expect("a checked model states the diameters of its bodies in fluids")
            };
            mesh.hydrodynamic_loads(&medium, hull).into_iter().for_each(|term| builder.add(term));
        }
    }

    fn bodies(&self) -> Vec<(String, &str)> {
        let bodies = self.bodies.iter().enumerate();
        bodies.map(|(i, name)| (format!("bodies[{i}]"), name.as_str())).collect()
    }

    fn time(&self) -> Option<&TimeFunction> {
        Some(&self.time)
    }

    fn time_mut(&mut self) -> Option<&mut TimeFunction> {
        Some(&mut self.time)
    }

    /// The acceleration of the flow loads the added mass.
    fn uses_rates(&self) -> bool {
        true
    }

    /// Checks that the bodies are flexible and have a diameter.
    fn check(&self, path: &str, context: &dyn LoadContext) -> Vec<Finding> {
        let mut findings = Vec::new();
        for (key, name) in self.bodies() {
            let Some((owner, body)) = context.body(name) else { continue };
            let Some((section, _)) = body.section_and_material() else {
                let what = if body.is_shell() {
                    "a shell, of which the load is a `surface_fluid`"
                } else {
                    "which is rigid"
                };
                let found = format!("{}, {what}", quoted(name));
                findings.push(finding(format!("{path}.{key}"), found, "a beam or a cable").rests_on([owner]));
                continue;
            };
            let end = match body {
                Body::Beam(Beam { section_end, .. }) => section_end.as_deref(),
                _ => None,
            };
            let mut sections = [Some(section), end].into_iter().flatten();
            let shapeless =
                sections.find(|&name| context.section(name).is_some_and(|s| self.hull(s).is_none()));
            if let Some(section) = shapeless {
                let expected = format!("the diameter of {} that meets the flow, a number > 0", quoted(name));
                let error = finding(format!("{path}.diameter"), "no key `diameter`", expected)
                    .hint("the section is not round");
                let rests_on = [format!("{path}.diameter"), format!("sections.{section}"), owner];
                findings.push(Finding { absence: true, ..error.rests_on(rests_on) });
            }
        }
        findings
    }
}
