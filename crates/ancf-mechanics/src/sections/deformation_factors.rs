/// Factors of the parts of a section law by kind of deformation.
///
/// Factors 1 yield the elastic law. Retardation times τ yield the viscous law of the Kelvin-Voigt model: each part acts on the
/// strain plus τ times its rate. With equal times, stresses follow from the strain E + τ dE/dt.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DeformationFactors {
    /// Mean axial strain.
    pub stretch: f64,
    /// Mean shear strains.
    pub shear: f64,
    /// Axial strains of fibres less their mean.
    pub bending: f64,
    /// Twist.
    pub torsion: f64,
    /// Deformation of the section. It is the factor of continuum laws, which have no parts.
    pub section: f64,
}

impl DeformationFactors {
    /// Factors of the elastic law.
    pub const ELASTIC: Self = Self::uniform(1.0);

    /// Creates equal factors.
    pub const fn uniform(factor: f64) -> Self {
        Self { stretch: factor, shear: factor, bending: factor, torsion: factor, section: factor }
    }

    /// Returns the factor if all are equal.
    pub fn common(&self) -> Option<f64> {
        (*self == Self::uniform(self.section)).then_some(self.section)
    }
}
