use ancf_mechanics::fluid::{HydroSurface, SurfaceFlowLoad};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::errors::Finding;
use crate::loads::parts::{LoadBuilder, LoadContext, LoadKind};
use crate::model::{TimeFunction, elements_of, region_of_shell, shell_body};
use crate::units::Scaled;

/// Fluid around a shell: drag, lift, added mass and buoyancy.
///
/// The force depends on the local velocity only, without the wake. Forces per area with the relative velocity w, its part w_n
/// along the normal n and its part w_t along the surface: ½ρ (C_n |w_n| + C_l |w_t|) w_n n + ½ρ C_t |w_t| w_t.
///
/// Source: Morison et al. (1950); Sarpkaya & Isaacson (1981).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct SurfaceFluid {
    /// Name of the shell.
    pub body: String,
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
    /// Coefficients C_n and C_t of drag across and along the surface.
    #[unit(number)]
    #[schemars(inner(range(min = 0)))]
    pub drag: [f64; 2],
    /// Coefficient C_l of lift: the normal force ½ρ C_l |w_t| w_n per area; 0 by default, 2π for a thin airfoil in attached flow.
    #[serde(default)]
    #[unit(number)]
    #[schemars(extend("minimum" = 0))]
    pub lift: f64,
    /// Length a of the added mass ρ a per area across the surface, length; 0 by default, π b/4 on average for a strip of the width b.
    #[serde(default)]
    #[unit(length)]
    #[schemars(extend("minimum" = 0))]
    pub added_mass: f64,
    /// Name of a group of elements of a shear-deformable shell in the fluid; the whole shell by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub region: Option<String>,
}

impl LoadKind for SurfaceFluid {
    fn noun(&self) -> &'static str {
        "fluid on a shell"
    }

    fn build(&self, builder: &mut LoadBuilder<'_>) {
        let medium = builder.flow(self.density, self.current, &self.time);
        let Some((body, terms)) = builder.body(&self.body) else { return };
        let thickness = body.layup().map_or(0.0, |layup| layup.thickness);
        let surface =
            HydroSurface { thickness, drag: self.drag, lift: self.lift, added_length: self.added_mass };
        let elements = elements_of(body, self.region.as_deref());
        SurfaceFlowLoad::on(terms, elements, &medium, &surface)
            .into_iter()
            .for_each(|term| builder.add(term));
    }

    fn bodies(&self) -> Vec<(String, &str)> {
        vec![("body".into(), &self.body)]
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

    fn check(&self, path: &str, context: &dyn LoadContext) -> Vec<Finding> {
        let region = region_of_shell(path, self.region.as_deref(), context.body(&self.body));
        shell_body(path, context.body(&self.body)).or(region).into_iter().collect()
    }
}
