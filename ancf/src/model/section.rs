use std::f64::consts::PI;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::mechanics::{CrossSection, Moments};

/// A solid cross-section, centred on the beam's axis, with its principal axes along y and z.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Section {
    /// A full circle.
    Circle {
        /// Diameter, length.
        #[schemars(extend("exclusiveMinimum" = 0))]
        diameter: f64,
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
}

impl Section {
    /// Moments of area up to the fourth degree.
    ///
    /// Circle of radius R: A = πR², ∫y² = πR⁴/4, ∫y⁴ = πR⁶/8, ∫y²z² = πR⁶/24.
    /// Rectangle h × w: A = hw, ∫y² = wh³/12, ∫y⁴ = wh⁵/80, ∫y²z² = h³w³/144.
    pub fn moments(&self) -> Moments {
        match *self {
            Self::Circle { diameter } => {
                let radius = 0.5 * diameter;
                let area = PI * radius.powi(2);
                let second = area * radius.powi(2) / 4.0;
                let fourth = area * radius.powi(4) / 8.0;
                Moments { area, yy: second, zz: second, yyyy: fourth, zzzz: fourth, yyzz: fourth / 3.0 }
            }
            Self::Rectangle { height: h, width: w } => Moments {
                area: h * w,
                yy: w * h.powi(3) / 12.0,
                zz: h * w.powi(3) / 12.0,
                yyyy: w * h.powi(5) / 80.0,
                zzzz: h * w.powi(5) / 80.0,
                yyzz: h.powi(3) * w.powi(3) / 144.0,
            },
        }
    }

    /// The section as the elements see it, of a material with Poisson's ratio ν.
    pub fn cross_section(&self, _poisson: f64) -> CrossSection {
        let moments = self.moments();
        CrossSection {
            moments,
            inertia: [moments.yy, moments.zz],
            torsion: moments.yy + moments.zz,
            shear: [1.0; 2],
            points: Vec::new(),
        }
    }

    /// The section at a part of the way to another of the same kind; itself, if the kinds differ.
    pub(super) fn towards(&self, end: &Self, part: f64) -> Self {
        let mix = |x: f64, y: f64| x + (y - x) * part;
        match (*self, *end) {
            (Self::Circle { diameter }, Self::Circle { diameter: end }) => {
                Self::Circle { diameter: mix(diameter, end) }
            }
            (Self::Rectangle { height, width }, Self::Rectangle { height: h, width: w }) => {
                Self::Rectangle { height: mix(height, h), width: mix(width, w) }
            }
            _ => *self,
        }
    }
}
