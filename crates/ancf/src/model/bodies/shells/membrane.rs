use ancf_mechanics::shells::{MembraneEnergy, MembraneLaw};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Scaled;

/// Law of the membrane forces of a shell of one isotropic material. The bending stiffness remains linear.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields, default)]
pub struct Membrane {
    /// Law without wrinkles.
    #[unit(none)]
    pub law: MembraneKind,
    /// True for a tension field: wrinkles in place of compressive forces.
    pub tension_field: bool,
    /// Part of the energy against compression that remains in a tension field.
    #[unit(number)]
    #[schemars(extend("minimum" = 1e-6, "maximum" = 1))]
    pub slack: f64,
}

/// Law of a membrane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum MembraneKind {
    /// Linear in Green's strains, in plane stress.
    #[default]
    Linear,
    /// Incompressible rubber with the shear modulus E/3, for any stretch. Poisson's ratio is that of bending only.
    NeoHookean,
}

impl Default for Membrane {
    fn default() -> Self {
        Self { law: MembraneKind::Linear, tension_field: false, slack: 1e-4 }
    }
}

impl Membrane {
    /// Law of a section; `None` for the linear one.
    pub(crate) fn law(&self, young: f64, poisson: f64, thickness: f64) -> Option<MembraneLaw> {
        let energy = match self.law {
            MembraneKind::Linear => MembraneEnergy::Linear { stiffness: young * thickness, poisson },
            MembraneKind::NeoHookean => MembraneEnergy::NeoHookean { stiffness: young * thickness / 3.0 },
        };
        let is_linear = self.law == MembraneKind::Linear && !self.tension_field;
        (!is_linear).then(|| MembraneLaw { energy, tension_field: self.tension_field.then_some(self.slack) })
    }
}
