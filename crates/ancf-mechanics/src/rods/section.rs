use nalgebra::Vector3;

use crate::sections::{CrossSection, Lame};

/// Largest number of iterations for the stretch. Convergence is quadratic, except near the smallest force.
const ITERATIONS: usize = 50;

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
    /// Law of the axial strain.
    pub law: AxialLaw,
}

/// Law of the axial strain of a rod with the stretch λ = 1 + Γ_x and the stretch λ⁰ = 1 + ε⁰ without stress.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AxialLaw {
    /// n = EA (λ − λ⁰), M = EI (κ − κ⁰).
    #[default]
    Linear,
    /// Green's strain: n = ½ EA λ (λ² − λ⁰²), M = EI λ² (κ − κ⁰).
    Green,
}

impl RodSection {
    /// Creates a section of a beam with Green's strains, straight in the reference state.
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
            law: AxialLaw::Green,
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
            law: AxialLaw::Linear,
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

    /// Returns the relative stiffness about the strain ε⁰ without stress: (1 + ε⁰)² with Green's strain.
    pub fn stiffening(&self) -> f64 {
        self.bending_factor(0.0)
    }

    /// Returns the larger compliance of bending without tension.
    pub fn flexibility(&self) -> f64 {
        self.bend.y.max(self.bend.z)
    }

    /// Returns the larger compliance of bending under a normal force.
    pub fn flexibility_under(&self, normal: f64) -> f64 {
        self.flexibility() / self.bending_factor(self.extension(normal))
    }

    /// Returns λ − λ⁰ under a normal force.
    pub fn extension(&self, normal: f64) -> f64 {
        let linear = normal * self.stretch.x;
        match self.law {
            AxialLaw::Linear => linear,
            AxialLaw::Green => green_extension(1.0 + self.strain, linear),
        }
    }

    /// Returns the bending stiffness relative to EI at an extension.
    fn bending_factor(&self, extension: f64) -> f64 {
        match self.law {
            AxialLaw::Linear => 1.0,
            AxialLaw::Green => (1.0 + self.strain + extension).powi(2),
        }
    }

    /// Returns the strains Γ − ε⁰ and curvatures κ − κ⁰ of a force and a moment in the frame of the section.
    pub fn strains(&self, force: &Vector3<f64>, moment: &Vector3<f64>) -> [Vector3<f64>; 2] {
        let (stretch, bend) = (self.stretch.component_mul(force), self.bend.component_mul(moment));
        let extension = self.extension(force.x);
        let factor = self.bending_factor(extension);
        [
            Vector3::new(extension, stretch.y, stretch.z),
            Vector3::new(bend.x, bend.y / factor, bend.z / factor),
        ]
    }

    /// Returns a bound of the relative difference between the rod and Green's strains of a three-dimensional section:
    /// 3 (κᵀ diag(i_p², i_y², i_z²) κ) + |ε|, with the radii of gyration i and the sum κ of the magnitudes of the reference curvature
    /// and its change.
    ///
    /// The factor is that of an empirical bound for bending and torsion up to half a radian per thickness.
    pub fn law_difference(&self, force: &Vector3<f64>, moment: &Vector3<f64>) -> f64 {
        let bend = self.bend.component_mul(moment);
        let total = bend.abs() + self.curvature.abs();
        3.0 * total.component_mul(&total).dot(&self.gyration) + (self.stretch.x * force.x).abs()
    }
}

/// Returns e = λ − λ⁰ with ½ λ (λ² − λ⁰²) = n/EA, that is e³ + 3 λ⁰ e² + 2 λ⁰² e = 2 n/EA, by Newton's method.
///
/// The force has its minimum at λ = λ⁰/√3. Below it, this extension is returned.
fn green_extension(free: f64, force: f64) -> f64 {
    let least = free * (1.0 / 3.0_f64.sqrt() - 1.0);
    // The left-hand side is convex from there on: all iterates but the first are above the root.
    let mut e = (force / (free * free)).max(0.0);
    for _ in 0..ITERATIONS {
        let residual = ((e + 3.0 * free) * e + 2.0 * free * free) * e - 2.0 * force;
        let slope = (3.0 * e + 6.0 * free) * e + 2.0 * free * free;
        let next = (e - residual / slope).max(least);
        if (next - e).abs() <= f64::EPSILON * next.abs() {
            return next;
        }
        e = next;
    }
    e
}
