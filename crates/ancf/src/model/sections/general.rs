use ancf_mechanics::sections::Moments;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::ellipse::elliptic_moments;
use super::shape::{SectionShape, interpolate};
use crate::units::Scaled;

/// General section, defined by its constants. The moduli E and G are those of the material.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct GeneralSection {
    /// Area A, length².
    #[schemars(extend("exclusiveMinimum" = 0))]
    #[unit(length^2)]
    pub area: f64,
    /// Second moment of area ∫z² dA for bending about y, length⁴.
    #[schemars(extend("exclusiveMinimum" = 0))]
    #[unit(length^4)]
    pub iy: f64,
    /// Second moment of area ∫y² dA for bending about z, length⁴.
    #[schemars(extend("exclusiveMinimum" = 0))]
    #[unit(length^4)]
    pub iz: f64,
    /// Torsion constant, length⁴; iy + iz by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    #[unit(length^4)]
    pub j: Option<f64>,
    /// Shear factor along y; 1 by default. The shear stiffness is ky G A.
    #[serde(default = "one")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    #[unit(number)]
    pub ky: f64,
    /// Shear factor along z; 1 by default. The shear stiffness is kz G A.
    #[serde(default = "one")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    #[unit(number)]
    pub kz: f64,
    /// Second moment of area for the rotary inertia about y, length⁴; iy by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    #[unit(length^4)]
    pub mass_iy: Option<f64>,
    /// Second moment of area for the rotary inertia about z, length⁴; iz by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    #[unit(length^4)]
    pub mass_iz: Option<f64>,
}

fn one() -> f64 {
    1.0
}

impl SectionShape for GeneralSection {
    /// Area and second moments as given. Fourth moments are those of an ellipse with the same radii of gyration.
    ///
    /// Only continuum elements use fourth moments.
    fn moments(&self) -> Moments {
        elliptic_moments(self.area, self.iz, self.iy)
    }

    fn mass_moments(&self) -> Moments {
        elliptic_moments(self.area, self.mass_iz.unwrap_or(self.iz), self.mass_iy.unwrap_or(self.iy))
    }

    /// J as given, else iy + iz.
    fn torsion_constant(&self) -> f64 {
        self.j.unwrap_or(self.iy + self.iz)
    }

    /// Factors as given, for any ν.
    fn shear_factors(&self, _poisson: f64) -> [f64; 2] {
        [self.ky, self.kz]
    }

    /// Constants vary linearly; constants left out vary with their defaults.
    fn towards(&self, end: &Self, fraction: f64) -> Self {
        let linear = |of: &dyn Fn(&Self) -> f64| interpolate(of(self), of(end), fraction);
        let optional = |own: fn(&Self) -> Option<f64>, value: &dyn Fn(&Self) -> f64| {
            (own(self).is_some() || own(end).is_some()).then(|| linear(value))
        };
        Self {
            area: linear(&|s| s.area),
            iy: linear(&|s| s.iy),
            iz: linear(&|s| s.iz),
            j: optional(|s| s.j, &Self::torsion_constant),
            ky: linear(&|s| s.ky),
            kz: linear(&|s| s.kz),
            mass_iy: optional(|s| s.mass_iy, &|s| s.mass_iy.unwrap_or(s.iy)),
            mass_iz: optional(|s| s.mass_iz, &|s| s.mass_iz.unwrap_or(s.iz)),
        }
    }
}

#[cfg(test)]
impl GeneralSection {
    pub(super) const EXAMPLES: &[Self] = &[
        Self { area: 0.05, iy: 2e-4, iz: 4e-4, j: None, ky: 1.0, kz: 1.0, mass_iy: None, mass_iz: None },
        Self {
            area: 0.05,
            iy: 4e-4,
            iz: 2e-4,
            j: Some(3e-4),
            ky: 0.8,
            kz: 0.6,
            mass_iy: Some(3e-4),
            mass_iz: Some(5e-4),
        },
    ];
}
