use nalgebra::Matrix2;

use super::membrane_law::MembraneLaw;
use super::section::ShellSection;

/// Shear correction factor κ of transverse shear forces.
///
/// Source: Reissner (1945), homogeneous sections.
pub(crate) const SHEAR_CORRECTION: f64 = 5.0 / 6.0;

/// Stiffness and mass per area of a shear-deformable shell.
///
/// Units: S force/length, stiffness of the thickness force/length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThickSection {
    /// Stiffness of membrane strains and curvatures in plane stress.
    pub surface: ShellSection,
    /// Stiffness S of the transverse shear strains: q = S γ in the axes of the section, with the shear correction.
    pub shear: Matrix2<f64>,
    /// Stiffness of the thickness strain ½ (d·d − 1).
    pub thickness: f64,
    /// Moments ∫ ρ dz, ∫ ρ z dz and ∫ ρ z² dz of the mass about the middle surface.
    pub inertia: [f64; 3],
}

impl ThickSection {
    /// Returns the section whose thickness is a multiple of this one, as [`ShellSection::scaled`].
    #[must_use]
    pub fn scaled(&self, scale: f64) -> Self {
        let [mass, moment, rotary] = self.inertia;
        Self {
            surface: self.surface.scaled(scale),
            shear: self.shear * scale,
            thickness: self.thickness * scale,
            inertia: [mass * scale, moment * (scale * scale), rotary * (scale * scale * scale)],
        }
    }

    /// Returns the section with another law of the membrane forces.
    #[must_use]
    pub fn with_law(self, law: Option<MembraneLaw>) -> Self {
        Self { surface: self.surface.with_law(law), ..self }
    }
}
