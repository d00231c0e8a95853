use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::mechanics::Lame;

/// An isotropic St. Venant-Kirchhoff material.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Density ρ, mass/volume.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub density: f64,
    /// Young's modulus E, force/area.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub young: f64,
    /// Poisson's ratio ν, −1 < ν < 0.5; 0 by default.
    #[serde(default)]
    #[schemars(extend("exclusiveMinimum" = -1, "exclusiveMaximum" = 0.5))]
    pub poisson: f64,
}

impl Material {
    /// Lamé's constants λ = Eν/((1+ν)(1−2ν)) and G = E/(2(1+ν)).
    pub fn lame(&self) -> Lame {
        Lame {
            lambda: self.young * self.poisson / ((1.0 + self.poisson) * (1.0 - 2.0 * self.poisson)),
            shear: self.young / (2.0 * (1.0 + self.poisson)),
        }
    }
}
