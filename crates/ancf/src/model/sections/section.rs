use std::f64::consts::PI;

use ancf_mechanics::sections::{CrossSection, Moments, SectionPoint};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A cross-section, centred on the beam's axis, with its principal axes along y and z.
///
/// Second moments have the names of the axes about which they bend: `iy` = ∫z² dA, `iz` = ∫y² dA. Shear factors have
/// those of their forces: `ky` belongs to a shear force along y.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Section {
    /// A full circle.
    Circle {
        /// Diameter, length.
        #[schemars(extend("exclusiveMinimum" = 0))]
        diameter: f64,
    },
    /// A circular tube.
    Tube {
        /// Outer diameter, length.
        #[schemars(extend("exclusiveMinimum" = 0))]
        outer: f64,
        /// Inner diameter, length; less than the outer.
        #[schemars(extend("exclusiveMinimum" = 0))]
        inner: f64,
    },
    /// A full rectangle.
    Rectangle {
        /// Extent along the section's y-axis, length.
        #[schemars(extend("exclusiveMinimum" = 0))]
        height: f64,
        /// Extent along the section's z-axis, length.
        #[schemars(extend("exclusiveMinimum" = 0))]
        width: f64,
    },
    /// A full ellipse.
    Ellipse {
        /// Extent along the section's y-axis, length: twice that semi-axis.
        #[schemars(extend("exclusiveMinimum" = 0))]
        height: f64,
        /// Extent along the section's z-axis, length: twice that semi-axis.
        #[schemars(extend("exclusiveMinimum" = 0))]
        width: f64,
    },
    /// A section known by its numbers only, with moduli E and G of its material.
    General {
        /// Area A, length².
        #[schemars(extend("exclusiveMinimum" = 0))]
        area: f64,
        /// Second moment ∫z² dA, length⁴: for bending about y, deflections along z.
        #[schemars(extend("exclusiveMinimum" = 0))]
        iy: f64,
        /// Second moment ∫y² dA, length⁴: for bending about z, deflections along y.
        #[schemars(extend("exclusiveMinimum" = 0))]
        iz: f64,
        /// Torsion constant, length⁴; iy + iz by default.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        j: Option<f64>,
        /// Shear factor of forces along y: their stiffness is ky G A; 1 by default.
        #[serde(default = "one")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        ky: f64,
        /// Shear factor of forces along z: their stiffness is kz G A; 1 by default.
        #[serde(default = "one")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        kz: f64,
        /// ∫z² dA of the rotary inertia about y, density times this, length⁴; iy by default.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        mass_iy: Option<f64>,
        /// ∫y² dA of the rotary inertia about z, density times this, length⁴; iz by default.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        mass_iz: Option<f64>,
    },
}

fn one() -> f64 {
    1.0
}

impl Section {
    /// Moments of area up to the fourth degree.
    ///
    /// Tube of radii R, r: A = π(R² − r²), ∫y² = A(R² + r²)/4, ∫y⁴ = A(R⁴ + R²r² + r⁴)/8, ∫y²z² = ∫y⁴/3; circle with r = 0.
    /// Rectangle h × w: A = hw, ∫y² = wh³/12, ∫y⁴ = wh⁵/80, ∫y²z² = h³w³/144.
    /// Ellipse of semi-axes a, b: A = πab, ∫y² = Aa²/4, ∫y⁴ = Aa⁴/8, ∫y²z² = Aa²b²/24.
    ///
    /// A general section has the fourth moments of the ellipse-like section with its area and second moments:
    /// ∫y⁴ = 2(∫y²)²/A, ∫y²z² = ⅔∫y² ∫z²/A. Only elements that are continua across the section ask for fourth moments.
    pub fn moments(&self) -> Moments {
        match *self {
            Self::Circle { diameter } => annulus(0.5 * diameter, 0.0),
            Self::Tube { outer, inner } => annulus(0.5 * outer, 0.5 * inner),
            Self::Rectangle { height: h, width: w } => Moments {
                area: h * w,
                yy: w * h.powi(3) / 12.0,
                zz: h * w.powi(3) / 12.0,
                yyyy: w * h.powi(5) / 80.0,
                zzzz: h * w.powi(5) / 80.0,
                yyzz: h.powi(3) * w.powi(3) / 144.0,
            },
            Self::Ellipse { height, width } => {
                let area = PI * (0.5 * height) * (0.5 * width);
                elliptic(area, area * height * height / 16.0, area * width * width / 16.0)
            }
            Self::General { area, iy, iz, .. } => elliptic(area, iz, iy),
        }
    }

    /// The moments that times the density are the inertia per length: those of area, but for what a general section
    /// says otherwise.
    pub fn mass_moments(&self) -> Moments {
        match *self {
            Self::General { area, iy, iz, mass_iy, mass_iz, .. } => {
                elliptic(area, mass_iz.unwrap_or(iz), mass_iy.unwrap_or(iy))
            }
            _ => self.moments(),
        }
    }

    /// The section as the elements see it, of a material with Poisson's ratio ν.
    pub fn cross_section(&self, poisson: f64) -> CrossSection {
        let (moments, mass) = (self.moments(), self.mass_moments());
        CrossSection {
            moments,
            inertia: [mass.yy, mass.zz],
            torsion: self.torsion_constant(),
            shear: self.shear_factors(poisson),
            points: self.points().unwrap_or_else(|| elliptic_points(moments)),
        }
    }

    /// The section at a part of the way to another of the same kind; itself, if the kinds differ.
    pub(crate) fn towards(&self, end: &Self, part: f64) -> Self {
        let mix = |x: f64, y: f64| x + (y - x) * part;
        match (*self, *end) {
            (Self::Circle { diameter }, Self::Circle { diameter: end }) => {
                Self::Circle { diameter: mix(diameter, end) }
            }
            (Self::Tube { outer, inner }, Self::Tube { outer: wide, inner: narrow }) => {
                Self::Tube { outer: mix(outer, wide), inner: mix(inner, narrow) }
            }
            (Self::Rectangle { height, width }, Self::Rectangle { height: h, width: w }) => {
                Self::Rectangle { height: mix(height, h), width: mix(width, w) }
            }
            (Self::Ellipse { height, width }, Self::Ellipse { height: h, width: w }) => {
                Self::Ellipse { height: mix(height, h), width: mix(width, w) }
            }
            _ => *self,
        }
    }
}

/// Points of the ellipse with the given second moments for its area, their weights brought to the area.
fn elliptic_points(m: Moments) -> Vec<SectionPoint> {
    let [height, width] = [m.yy, m.zz].map(|second| 4.0 * (second / m.area).sqrt());
    let points = Section::Ellipse { height, width }.points().unwrap_or_default();
    let area: f64 = points.iter().map(|point| point.weight).sum();
    points.into_iter().map(|point| SectionPoint { weight: point.weight * m.area / area, ..point }).collect()
}

/// Between two circles of radii R > r.
fn annulus(outer: f64, inner: f64) -> Moments {
    let area = PI * ((outer - inner) * (outer + inner));
    let (square, hole) = (outer.powi(2), inner.powi(2));
    let second = area * (square + hole) / 4.0;
    let fourth = area * (outer.powi(4) + square * hole + inner.powi(4)) / 8.0;
    Moments { area, yy: second, zz: second, yyyy: fourth, zzzz: fourth, yyzz: fourth / 3.0 }
}

/// Fourth moments as an ellipse has them.
fn elliptic(area: f64, yy: f64, zz: f64) -> Moments {
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

impl Section {
    /// The radius of a section that is round outside.
    pub(crate) const fn radius(&self) -> Option<f64> {
        match *self {
            Self::Circle { diameter: d } | Self::Tube { outer: d, .. } => Some(0.5 * d),
            _ => None,
        }
    }
}
