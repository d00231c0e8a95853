use ancf_mechanics::sections::{Moments, SectionPoint};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::outline::SectionOutline;
use super::shape::{SectionShape, interpolate};
use super::tube::Tube;
use crate::units::Scaled;

/// Full circle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Circle {
    /// Diameter, length.
    #[schemars(extend("exclusiveMinimum" = 0))]
    #[unit(length)]
    pub diameter: f64,
}

/// The formulas of a [`Tube`] with an inner diameter of zero apply.
impl SectionShape for Circle {
    /// A = πR², ∫y² = AR²/4, ∫y⁴ = AR⁴/8, ∫y²z² = ∫y⁴/3 with the radius R.
    fn moments(&self) -> Moments {
        self.without_bore().moments()
    }

    /// J = ∫y² + ∫z².
    fn torsion_constant(&self) -> f64 {
        self.without_bore().torsion_constant()
    }

    /// 6(1+ν)/(7+6ν) along y and z.
    ///
    /// Source: Cowper (1966).
    fn shear_factors(&self, poisson: f64) -> [f64; 2] {
        self.without_bore().shear_factors(poisson)
    }

    fn points(&self) -> Option<Vec<SectionPoint>> {
        self.without_bore().points()
    }

    fn outline(&self) -> SectionOutline {
        SectionOutline::ellipse([0.5 * self.diameter; 2])
    }

    fn outer_radius(&self) -> Option<f64> {
        Some(0.5 * self.diameter)
    }

    fn towards(&self, end: &Self, fraction: f64) -> Self {
        Self { diameter: interpolate(self.diameter, end.diameter, fraction) }
    }
}

impl Circle {
    const fn without_bore(self) -> Tube {
        Tube { outer: self.diameter, inner: 0.0 }
    }

    #[cfg(test)]
    pub(super) const EXAMPLES: &[Self] = &[Self { diameter: 0.3 }];
}
