use ancf_mechanics::sections::{CrossSection, Moments, SectionPoint};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::circle::Circle;
use super::custom::{CustomSection, SectionObject};
use super::ellipse::{Ellipse, equivalent_points};
use super::general::GeneralSection;
use super::rectangle::Rectangle;
use super::shape::SectionShape;
use super::tube::Tube;
use crate::units::Scaled;

/// Declares the kinds of sections of model files: variant and data of each.
macro_rules! sections {
    ($($kind:ident($data:ident),)*) => {
        /// Cross-section, centred on the axis of the beam, with principal axes along y and z.
        ///
        /// Second moments are named by the axis of bending: `iy` = ∫z² dA, `iz` = ∫y² dA. Shear factors are named by the direction
        /// of the shear force: `ky` belongs to a force along y.
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
        #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
        #[expect(missing_docs, reason = "the data of each kind are documented")]
        pub enum Section {
            $($kind($data),)*
            /// A section of a kind that a program adds; model files have none.
            #[serde(skip)]
            #[schemars(skip)]
            Custom(CustomSection),
        }

        impl Section {
            /// Section as an implementation of its kind.
            pub fn shape(&self) -> &dyn SectionShape {
                match self {
                    $(Self::$kind(section) => section,)*
                    Self::Custom(section) => section.shape(),
                }
            }

            /// Section at a fraction of the way to another one; `None` if the kinds differ.
            pub(crate) fn towards(&self, end: &Self, fraction: f64) -> Option<Self> {
                match (self, end) {
                    $((Self::$kind(start), Self::$kind(end)) => {
                        Some(Self::$kind(start.towards(end, fraction)))
                    })*
                    (Self::Custom(start), Self::Custom(end)) => {
                        start.towards(end, fraction).map(Self::Custom)
                    }
                    _ => None,
                }
            }

            /// Examples of all kinds.
            #[cfg(test)]
            pub(super) fn examples() -> Vec<Self> {
                let kinds = [$($data::EXAMPLES.iter().copied().map(Self::$kind).collect::<Vec<_>>(),)*];
                kinds.concat()
            }
        }

        $(impl From<$data> for Section {
            fn from(section: $data) -> Self {
                Self::$kind(section)
            }
        })*
    };
}

sections! {
    Circle(Circle),
    Tube(Tube),
    Rectangle(Rectangle),
    Ellipse(Ellipse),
    General(GeneralSection),
}

impl Section {
    /// Section of a kind that a program adds.
    pub fn custom(section: impl SectionObject) -> Self {
        Self::Custom(CustomSection::new(section))
    }

    /// Full circle of a diameter.
    pub const fn circle(diameter: f64) -> Self {
        Self::Circle(Circle { diameter })
    }

    /// Circular tube of an outer and an inner diameter.
    pub const fn tube(outer: f64, inner: f64) -> Self {
        Self::Tube(Tube { outer, inner })
    }

    /// Full rectangle with its height along y and its width along z.
    pub const fn rectangle(height: f64, width: f64) -> Self {
        Self::Rectangle(Rectangle { height, width })
    }

    /// Full ellipse with its height along y and its width along z.
    pub const fn ellipse(height: f64, width: f64) -> Self {
        Self::Ellipse(Ellipse { height, width })
    }

    /// Moments of area up to the fourth degree.
    pub fn moments(&self) -> Moments {
        self.shape().moments()
    }

    /// Moments that give the inertia per length when multiplied by the density.
    pub fn mass_moments(&self) -> Moments {
        self.shape().mass_moments()
    }

    /// St. Venant's torsion constant J, length⁴. The twist per length under a torque M is M/(G J).
    pub fn torsion_constant(&self) -> f64 {
        self.shape().torsion_constant()
    }

    /// Shear factors [k_y, k_z] for Poisson's ratio ν: the shear stiffness along y is k_y G A.
    pub fn shear_factors(&self, poisson: f64) -> [f64; 2] {
        self.shape().shear_factors(poisson)
    }

    /// Integration points, exact for polynomials of degree seven in y and z; none for a general section.
    pub fn points(&self) -> Option<Vec<SectionPoint>> {
        self.shape().points()
    }

    /// Section as the elements use it, for Poisson's ratio ν of the material.
    pub fn cross_section(&self, poisson: f64) -> CrossSection {
        let (moments, mass) = (self.moments(), self.mass_moments());
        CrossSection {
            moments,
            inertia: [mass.yy, mass.zz],
            torsion: self.torsion_constant(),
            shear: self.shear_factors(poisson),
            points: self.points().unwrap_or_else(|| equivalent_points(moments)),
        }
    }
}
