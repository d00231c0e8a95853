use std::f64::consts::PI;

use ancf_mechanics::sections::{Moments, SectionPoint};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::cubature::mirrored;
use super::outline::SectionOutline;
use super::shape::{SectionShape, interpolate};
use crate::units::Scaled;

/// Full rectangle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Rectangle {
    /// Extent along the y-axis of the section, length.
    #[schemars(extend("exclusiveMinimum" = 0))]
    #[unit(length)]
    pub height: f64,
    /// Extent along the z-axis of the section, length.
    #[schemars(extend("exclusiveMinimum" = 0))]
    #[unit(length)]
    pub width: f64,
}

impl SectionShape for Rectangle {
    /// A = hw, ∫y² = wh³/12, ∫y⁴ = wh⁵/80, ∫y²z² = h³w³/144 with height h and width w.
    fn moments(&self) -> Moments {
        let Self { height: h, width: w } = *self;
        Moments {
            area: h * w,
            yy: w * h.powi(3) / 12.0,
            zz: h * w.powi(3) / 12.0,
            yyyy: w * h.powi(5) / 80.0,
            zzzz: h * w.powi(5) / 80.0,
            yyzz: h.powi(3) * w.powi(3) / 144.0,
        }
    }

    /// J = a b³ (1/3 − 64 b/(π⁵ a) Σ tanh(nπa/2b)/n⁵) over odd n, with the sides a ≥ b.
    ///
    /// The sum is computed as Σ 1/n⁵ − Σ 2/((exp(nπa/b) + 1) n⁵). Terms of the second sum decrease by a factor of exp(2π) or
    /// more.
    ///
    /// Source: Timoshenko & Goodier (1970), eq. (160).
    fn torsion_constant(&self) -> f64 {
        let (a, b) = (self.height.max(self.width), self.height.min(self.width));
        let rest: f64 = (0..7)
            .map(|k| f64::from(2 * k + 1))
            .map(|n| 2.0 / (((n * PI * a / b).exp() + 1.0) * n.powi(5)))
            .sum();
        a * b.powi(3) * (1.0 / 3.0 - 64.0 * b / (PI.powi(5) * a) * (ODD_FIFTHS - rest))
    }

    /// With a = h ≤ b = w, over odd n and with the shear strains of the twist κ,
    ///
    /// 2E_xy = −(8κa/π²) Σ ± sinh(nπz/a)/cosh(nπb/2a) cos(nπy/a)/n²,
    /// 2E_xz = 2κy − (8κa/π²) Σ ± cosh(nπz/a)/cosh(nπb/2a) sin(nπy/a)/n².
    ///
    /// If the height is larger, the section is turned by a right angle. Points outside have the values of the edge.
    ///
    /// Source: Timoshenko & Goodier (1970), section 109.
    fn warping_gradient(&self, [y, z]: [f64; 2]) -> [f64; 2] {
        let Self { height, width } = *self;
        if height > width {
            let [of_y, of_z] = Self { height: width, width: height }.warping_gradient([z, -y]);
            return [-of_z, of_y];
        }
        let (y, z) = (y.clamp(-0.5 * height, 0.5 * height), z.clamp(-0.5 * width, 0.5 * width));
        let [mut along_y, mut along_z] = [0.0, 2.0 * y];
        for k in 0..TERMS {
            let n = f64::from(2 * k + 1);
            let (p, sign) = (n * PI / height, if k % 2 == 0 { 1.0 } else { -1.0 });
            // Of sinh and cosh, relative to cosh(½pb), without overflow.
            let [near, far] = [z.abs(), -z.abs()].map(|z| (p * (z - 0.5 * width)).exp());
            if near < f64::EPSILON {
                break;
            }
            let scale = sign * 8.0 * height / (PI * n).powi(2) / (1.0 + (-p * width).exp());
            along_y -= scale * (near - far) * z.signum() * (p * y).cos();
            along_z -= scale * (near + far) * (p * y).sin();
        }
        [along_y + z, along_z - y]
    }

    /// 10(1+ν)/(12+11ν) along y and z.
    ///
    /// Source: Cowper (1966).
    fn shear_factors(&self, poisson: f64) -> [f64; 2] {
        [10.0 * (1.0 + poisson) / (12.0 + 11.0 * poisson); 2]
    }

    /// Four Gauss points along each axis.
    ///
    /// Source: Abramowitz & Stegun (1964), table 25.4.
    fn points(&self) -> Option<Vec<SectionPoint>> {
        let root = 2.0 * 1.2_f64.sqrt();
        let (inner, outer) = (((3.0 - root) / 7.0).sqrt(), ((3.0 + root) / 7.0).sqrt());
        let part = 30.0_f64.sqrt();
        let (heavy, light) = ((18.0 + part) / 72.0, (18.0 - part) / 72.0);
        let point = |(y, v): (f64, f64), (z, w): (f64, f64)| SectionPoint {
            y: 0.5 * self.height * y,
            z: 0.5 * self.width * z,
            weight: self.height * self.width * v * w,
        };
        let (near, far) = ((inner, heavy), (outer, light));
        Some(mirrored([point(near, near), point(near, far), point(far, near), point(far, far)]))
    }

    fn outline(&self) -> SectionOutline {
        let (a, b) = (0.5 * self.height, 0.5 * self.width);
        SectionOutline::polygon(vec![[a, -b], [a, b], [-a, b], [-a, -b]])
    }

    fn towards(&self, end: &Self, fraction: f64) -> Self {
        Self {
            height: interpolate(self.height, end.height, fraction),
            width: interpolate(self.width, end.width, fraction),
        }
    }
}

/// Number of terms of the series of the warping function, whose terms decrease with n² at the edges.
const TERMS: u32 = 200;

/// Σ 1/n⁵ over odd n: (31/32) ζ(5).
const ODD_FIFTHS: f64 = 1.004_523_762_795_139_6;

#[cfg(test)]
impl Rectangle {
    pub(super) const EXAMPLES: &[Self] = &[
        Self { height: 0.3, width: 0.2 },
        Self { height: 0.01, width: 0.35 },
        Self { height: 0.2, width: 0.2 },
    ];
}
