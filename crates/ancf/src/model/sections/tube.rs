use std::f64::consts::PI;

use ancf_mechanics::sections::{Moments, SectionPoint};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::cubature::elliptic_points;
use super::outline::{OutlineCurve, SectionOutline};
use super::shape::{SectionShape, interpolate};
use crate::errors::{Finding, finding, number};
use crate::units::Scaled;

/// Circular tube.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Tube {
    /// Outer diameter, length.
    #[schemars(extend("exclusiveMinimum" = 0))]
    #[unit(length)]
    pub outer: f64,
    /// Inner diameter, length; less than the outer diameter.
    #[schemars(extend("exclusiveMinimum" = 0))]
    #[unit(length)]
    pub inner: f64,
}

impl SectionShape for Tube {
    /// A = π(R² − r²), ∫y² = A(R² + r²)/4, ∫y⁴ = A(R⁴ + R²r² + r⁴)/8, ∫y²z² = ∫y⁴/3 with the radii R > r.
    fn moments(&self) -> Moments {
        let (outer, inner) = (0.5 * self.outer, 0.5 * self.inner);
        let area = PI * ((outer - inner) * (outer + inner));
        let (square, hole) = (outer.powi(2), inner.powi(2));
        let second = area * (square + hole) / 4.0;
        let fourth = area * (outer.powi(4) + square * hole + inner.powi(4)) / 8.0;
        Moments { area, yy: second, zz: second, yyyy: fourth, zzzz: fourth, yyzz: fourth / 3.0 }
    }

    /// J = ∫y² + ∫z².
    fn torsion_constant(&self) -> f64 {
        2.0 * self.moments().yy
    }

    /// 6(1+ν)(1+m²)²/((7+6ν)(1+m²)² + (20+12ν)m²) along y and z, m = inner/outer.
    ///
    /// Source: Cowper (1966).
    fn shear_factors(&self, poisson: f64) -> [f64; 2] {
        let m = self.inner / self.outer;
        let square = (1.0 + m * m).powi(2);
        let denominator = (7.0 + 6.0 * poisson) * square + (20.0 + 12.0 * poisson) * m * m;
        [6.0 * (1.0 + poisson) * square / denominator; 2]
    }

    fn points(&self) -> Option<Vec<SectionPoint>> {
        Some(elliptic_points(self.outer, self.outer, self.inner / self.outer))
    }

    fn outline(&self) -> SectionOutline {
        let circle = |diameter: f64| OutlineCurve::Ellipse([0.5 * diameter; 2]);
        SectionOutline { outer: circle(self.outer), bore: Some(circle(self.inner)) }
    }

    fn outer_radius(&self) -> Option<f64> {
        Some(0.5 * self.outer)
    }

    fn towards(&self, end: &Self, fraction: f64) -> Self {
        Self {
            outer: interpolate(self.outer, end.outer, fraction),
            inner: interpolate(self.inner, end.inner, fraction),
        }
    }

    /// Requires an inner diameter below the outer diameter.
    fn check(&self, path: &str) -> Vec<Finding> {
        let Self { outer, inner } = *self;
        let found = (inner >= outer).then(|| {
            let expected = format!("less than the outer diameter, {}", number(outer));
            finding(format!("{path}.inner"), number(inner), expected).rests_on([format!("{path}.outer")])
        });
        found.into_iter().collect()
    }
}

#[cfg(test)]
impl Tube {
    pub(super) const EXAMPLES: &[Self] = &[
        Self { outer: 0.4, inner: 0.25 },
        Self { outer: 0.3, inner: 0.29 },
        Self { outer: 0.3, inner: 1e-9 },
    ];
}
