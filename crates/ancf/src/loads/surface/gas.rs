use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::errors::{Finding, finding, quoted};
use crate::loads::parts::{LoadBuilder, LoadContext, LoadKind};
use crate::model::{TimeFunction, region_of_shell, shell_body};
use crate::units::Scaled;

/// Gas in a volume V that shells enclose, of one pressure p = p₀ (m(t) V₀/V)^κ.
///
/// V₀ is the volume of the undeformed shells, p₀ the pressure there, κ the exponent. The gas has no mass.
/// The load factor s of statics brings the gas from the pressure outside, p_a, to p₀: p₀ is replaced by p_a + s (p₀ − p_a).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Gas {
    /// Name of the columns of pressure and volume.
    #[schemars(length(min = 1))]
    pub name: String,
    /// Shells around the gas.
    #[schemars(length(min = 1))]
    pub surfaces: Vec<GasSurface>,
    /// Absolute pressure p₀ in the undeformed volume, force/length².
    #[unit(force / length^2)]
    #[schemars(extend("minimum" = 0))]
    pub pressure: f64,
    /// Absolute pressure p_a outside, force/length². With the default 0, `pressure` is that in a vacuum.
    #[serde(default)]
    #[unit(force / length^2)]
    #[schemars(extend("minimum" = 0))]
    pub ambient: f64,
    /// Exponent κ: 1 at constant temperature, 1.4 in air without heat exchange, 0 at constant pressure.
    #[serde(default = "isothermal")]
    #[unit(number)]
    #[schemars(extend("minimum" = 0, "maximum" = 10))]
    pub exponent: f64,
    /// Point to which the edges of openings are connected by straight lines, length. With symmetry planes, a point in all of them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[unit(length)]
    pub apex: Option<[f64; 3]>,
    /// Amount of gas m as a function of time, relative to that of `pressure`. Added gas has the state of the gas inside. Statics ignores it, except the value of an input.
    #[serde(default)]
    pub time: TimeFunction,
}

/// Surface around a gas.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct GasSurface {
    /// Name of the shell. Its normal, that of u and v or of the order of the nodes of elements, points out of the gas.
    pub body: String,
    /// Name of a group of elements of a shear-deformable shell; the whole shell by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub region: Option<String>,
    /// True if the normal points into the gas.
    #[serde(default)]
    pub reversed: bool,
}

const fn isothermal() -> f64 {
    1.0
}

impl LoadKind for Gas {
    fn noun(&self) -> &'static str {
        "gas"
    }

    /// Adds nothing: the gas has a coordinate and an equation, which the assembly numbers.
    fn build(&self, _builder: &mut LoadBuilder<'_>) {}

    fn name(&self) -> Option<&str> {
        Some(&self.name)
    }

    fn bodies(&self) -> Vec<(String, &str)> {
        let named = self.surfaces.iter().enumerate();
        named.map(|(k, surface)| (format!("surfaces[{k}].body"), surface.body.as_str())).collect()
    }

    fn time(&self) -> Option<&TimeFunction> {
        Some(&self.time)
    }

    fn time_mut(&mut self) -> Option<&mut TimeFunction> {
        Some(&mut self.time)
    }

    fn is_follower(&self) -> bool {
        true
    }

    fn check(&self, path: &str, context: &dyn LoadContext) -> Vec<Finding> {
        let of_surface = |(k, surface): (usize, &GasSurface)| {
            let (path, body) = (format!("{path}.surfaces[{k}]"), context.body(&surface.body));
            let region = region_of_shell(&path, surface.region.as_deref(), context.body(&surface.body));
            shell_body(&path, body).or(region)
        };
        let mut findings: Vec<Finding> = self.surfaces.iter().enumerate().filter_map(of_surface).collect();
        for (k, surface) in self.surfaces.iter().enumerate() {
            let overlaps = |other: &GasSurface| {
                let whole = other.region.is_none() || surface.region.is_none();
                other.body == surface.body && (whole || other.region == surface.region)
            };
            if self.surfaces[..k].iter().any(overlaps) {
                let found = format!("{} a second time", quoted(&surface.body));
                findings.push(finding(format!("{path}.surfaces[{k}].body"), found, "each surface once"));
            }
        }
        findings
    }
}
