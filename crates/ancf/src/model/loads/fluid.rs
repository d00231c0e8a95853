use ancf_mechanics::fluid::HydroSection;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::model::functions::TimeFunction;
use crate::model::sections::{Section, disk_area};
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
    /// Function of time that multiplies the current. Statics ignores it.
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
