use crate::model::{Model, Section};
use crate::units::{Dimension, ScaleChoice, Scaled, Scales, number};

impl Model {
    /// Converts the model to other units. The result is a model in its own units, without a choice of scales.
    ///
    /// Tolerances of absolute convergence criteria are not converted, because they refer to the units of the solver.
    #[must_use]
    pub fn scaled(&self, scales: &Scales) -> Self {
        let couplings = self.scaled_couplings(scales);
        let converted = <Self as Scaled>::scaled(self.clone(), scales);
        Self { units: None, couplings, scales: ScaleChoice::None, ..converted }
    }
}

impl Scaled for Section {
    fn scaled(self, scales: &Scales) -> Self {
        // The inherent function.
        Self::scaled(self, scales)
    }
}

impl Section {
    fn scaled(self, s: &Scales) -> Self {
        let length = |x| number(x, Dimension::LENGTH, s);
        let second = |x| number(x, Dimension::SECOND_MOMENT, s);
        match self {
            Self::Circle { diameter } => Self::Circle { diameter: length(diameter) },
            Self::Tube { outer, inner } => Self::Tube { outer: length(outer), inner: length(inner) },
            Self::Rectangle { height, width } => {
                Self::Rectangle { height: length(height), width: length(width) }
            }
            Self::Ellipse { height, width } => Self::Ellipse { height: length(height), width: length(width) },
            Self::General { area, iy, iz, j, ky, kz, mass_iy, mass_iz } => Self::General {
                area: number(area, Dimension::AREA, s),
                iy: second(iy),
                iz: second(iz),
                j: j.map(second),
                ky,
                kz,
                mass_iy: mass_iy.map(second),
                mass_iz: mass_iz.map(second),
            },
        }
    }
}
