use nalgebra::Vector3;

use crate::sections::{CrossSection, Lame};

/// Elasticity and reference curvature of a rod at an arc length.
///
/// Components along x (the normal of the section), y and z of the section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RodSection {
    /// Compliances 1/EA, 1/(k_y GA) and 1/(k_z GA).
    pub stretch: Vector3<f64>,
    /// Compliances 1/GJ, 1/EI_y and 1/EI_z.
    pub bend: Vector3<f64>,
    /// Curvature κ⁰ without stress: twist about x, bending about y and z.
    pub curvature: Vector3<f64>,
    /// Axial strain ε⁰ without stress.
    pub strain: f64,
    /// Squares of the radii of gyration: polar, of I_y and of I_z.
    pub gyration: Vector3<f64>,
}

impl RodSection {
    /// Creates a section of a beam, straight in the reference state.
    pub fn beam(section: &CrossSection, material: Lame) -> Self {
        let (moments, young, shear) = (section.moments, material.young(), material.shear);
        let [along_y, along_z] = section.shear.map(|factor| 1.0 / (factor * shear * moments.area));
        Self {
            stretch: Vector3::new(1.0 / (young * moments.area), along_y, along_z),
            bend: Vector3::new(
                1.0 / (shear * section.torsion),
                1.0 / (young * moments.zz),
                1.0 / (young * moments.yy),
            ),
            curvature: Vector3::zeros(),
            strain: 0.0,
            gyration: Vector3::new(moments.yy + moments.zz, moments.zz, moments.yy) / moments.area,
        }
    }

    /// Creates a section of a cable: no shear, no torsion, and the bending stiffness E ∫y² dA in all planes.
    pub fn cable(section: &CrossSection, material: Lame) -> Self {
        let (moments, young) = (section.moments, material.young());
        let bend = 1.0 / (young * moments.yy);
        Self {
            stretch: Vector3::new(1.0 / (young * moments.area), 0.0, 0.0),
            bend: Vector3::new(0.0, bend, bend),
            curvature: Vector3::zeros(),
            strain: 0.0,
            gyration: Vector3::repeat(moments.yy / moments.area),
        }
    }

    /// Sets the curvature without stress.
    #[must_use]
    pub fn curved(self, curvature: Vector3<f64>) -> Self {
        Self { curvature, ..self }
    }

    /// Adds a strain and a curvature without stress.
    #[must_use]
    pub fn prestrained(self, strain: f64, curvature: Vector3<f64>) -> Self {
        Self { strain: self.strain + strain, curvature: self.curvature + curvature, ..self }
    }

    /// Returns the section of elements with the Green strains ε − ε⁰: stretch and bending are stiffer by (1 + ε⁰)².
    #[must_use]
    pub fn of_green_strains(self) -> Self {
        let stiffness = self.stiffening();
        Self {
            stretch: Vector3::new(self.stretch.x / stiffness, self.stretch.y, self.stretch.z),
            bend: Vector3::new(self.bend.x, self.bend.y / stiffness, self.bend.z / stiffness),
            ..self
        }
    }

    /// Returns (1 + ε⁰)², the relative stiffness of elements with the Green strains ε − ε⁰.
    pub fn stiffening(&self) -> f64 {
        (1.0 + self.strain).powi(2)
    }

    /// Returns the larger compliance of bending.
    pub fn flexibility(&self) -> f64 {
        self.bend.y.max(self.bend.z)
    }

    /// Returns the strains Γ and curvatures κ − κ⁰ of a force and a moment in the frame of the section.
    pub fn strains(&self, force: &Vector3<f64>, moment: &Vector3<f64>) -> [Vector3<f64>; 2] {
        [self.stretch.component_mul(force), self.bend.component_mul(moment)]
    }

    /// Returns a bound of the relative difference between the rod and Green's strains of a three-dimensional section:
    /// 3 (κᵀ diag(i_p², i_y², i_z²) κ) + |ε|, with the radii of gyration i and the sum κ of the magnitudes of the reference curvature
    /// and its change.
    ///
    /// The factor is that of an empirical bound for bending and torsion up to half a radian per thickness.
    pub fn law_difference(&self, force: &Vector3<f64>, moment: &Vector3<f64>) -> f64 {
        let [stretch, bend] = self.strains(force, moment);
        let total = bend.abs() + self.curvature.abs();
        3.0 * total.component_mul(&total).dot(&self.gyration) + stretch.x.abs()
    }
}
