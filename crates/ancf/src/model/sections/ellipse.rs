use std::f64::consts::PI;

use ancf_mechanics::sections::{Moments, SectionPoint};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::cubature::elliptic_points;
use super::outline::SectionOutline;
use super::shape::{SectionShape, interpolate};
use crate::units::Scaled;

/// Full ellipse.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Ellipse {
    /// Extent along the y-axis of the section, twice the semi-axis, length.
    #[schemars(extend("exclusiveMinimum" = 0))]
    #[unit(length)]
    pub height: f64,
    /// Extent along the z-axis of the section, twice the semi-axis, length.
    #[schemars(extend("exclusiveMinimum" = 0))]
    #[unit(length)]
    pub width: f64,
}

impl SectionShape for Ellipse {
    /// A = πab, ∫y² = Aa²/4, ∫y⁴ = Aa⁴/8, ∫y²z² = Aa²b²/24 with semi-axes a along y and b along z.
    fn moments(&self) -> Moments {
        let Self { height, width } = *self;
        let area = PI * (0.5 * height) * (0.5 * width);
        elliptic_moments(area, area * height * height / 16.0, area * width * width / 16.0)
    }

    /// J = πa³b³/(a² + b²).
    ///
    /// Source: Timoshenko & Goodier (1970), section 105.
    fn torsion_constant(&self) -> f64 {
        let (a, b) = (0.5 * self.height, 0.5 * self.width);
        PI * (a * b).powi(3) / (a * a + b * b)
    }

    /// ω = −(a² − b²)/(a² + b²) y z.
    ///
    /// Source: Timoshenko & Goodier (1970), section 105.
    fn warping_gradient(&self, [y, z]: [f64; 2]) -> [f64; 2] {
        let [a, b] = [self.height, self.width].map(|side| side * side);
        let factor = (b - a) / (a + b);
        [factor * z, factor * y]
    }

    /// 12(1+ν)a²(3a²+b²)/((40+37ν)a⁴ + (16+10ν)a²b² + νb⁴), with the semi-axis a along the force and the semi-axis b normal to it.
    ///
    /// For ν < 0 the formula fails for flat ellipses: the factor along the shorter axis is large, infinite or negative.
    ///
    /// Source: Cowper (1966).
    fn shear_factors(&self, poisson: f64) -> [f64; 2] {
        // `ratio` is b/a.
        let factor = |ratio: f64| {
            let square = ratio * ratio;
            12.0 * (1.0 + poisson) * (3.0 + square)
                / ((40.0 + 37.0 * poisson) + (16.0 + 10.0 * poisson) * square + poisson * square * square)
        };
        [factor(self.width / self.height), factor(self.height / self.width)]
    }

    fn points(&self) -> Option<Vec<SectionPoint>> {
        Some(elliptic_points(self.height, self.width, 0.0))
    }

    fn outline(&self) -> SectionOutline {
        SectionOutline::ellipse([0.5 * self.height, 0.5 * self.width])
    }

    fn towards(&self, end: &Self, fraction: f64) -> Self {
        Self {
            height: interpolate(self.height, end.height, fraction),
            width: interpolate(self.width, end.width, fraction),
        }
    }
}

/// Moments with the fourth degree of an ellipse: ∫y⁴ = 2(∫y²)²/A, ∫y²z² = ⅔∫y² ∫z²/A.
pub(super) fn elliptic_moments(area: f64, yy: f64, zz: f64) -> Moments {
    let fourth = |p: f64, q: f64| p * q / area;
    Moments {
        area,
        yy,
        zz,
        yyyy: 2.0 * fourth(yy, yy),
        zzzz: 2.0 * fourth(zz, zz),
        yyzz: fourth(yy, zz) / 1.5,
    }
}

/// Integration points of the ellipse with the same radii of gyration, with weights scaled to the area.
pub(super) fn equivalent_points(m: Moments) -> Vec<SectionPoint> {
    let [height, width] = [m.yy, m.zz].map(|second| 4.0 * (second / m.area).sqrt());
    let points = elliptic_points(height, width, 0.0);
    let area: f64 = points.iter().map(|point| point.weight).sum();
    points.into_iter().map(|point| SectionPoint { weight: point.weight * m.area / area, ..point }).collect()
}

#[cfg(test)]
impl Ellipse {
    pub(super) const EXAMPLES: &[Self] = &[
        Self { height: 0.2, width: 0.4 },
        Self { height: 0.5, width: 0.1 },
        Self { height: 0.3, width: 0.3 },
    ];
}
