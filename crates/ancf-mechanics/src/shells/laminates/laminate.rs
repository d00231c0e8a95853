use nalgebra::{Matrix2, Matrix3, Vector3};

use super::section::{ShellSection, SurfaceMaterial, strain_transform};
use super::thick_section::{SHEAR_CORRECTION, ThickSection};

/// Distance from the boundary of two plies, relative to the thickness, that counts as rounding.
const ON_BOUNDARY: f64 = 1e-9;

/// Constants of an orthotropic material in plane stress.
///
/// Units: moduli force/area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlyElasticity {
    /// Young's moduli E_L along the fibres and E_T transverse to them.
    pub young: [f64; 2],
    /// Poisson's ratio ν_LT: contraction transverse to the fibres by a stress along them.
    pub poisson: f64,
    /// Shear modulus G_LT.
    pub shear: f64,
    /// Transverse shear moduli G_LZ and G_TZ, Z along the normal. Thin shells do not use them.
    pub transverse_shear: [f64; 2],
}

impl PlyElasticity {
    /// Constants of an isotropic material.
    pub fn isotropic(young: f64, poisson: f64) -> Self {
        let shear = 0.5 * young / (1.0 + poisson);
        Self { young: [young; 2], poisson, shear, transverse_shear: [shear; 2] }
    }

    /// Returns the stiffness in the axes of the fibres: σ = Q ε for (LL, TT, 2 LT).
    fn stiffness(&self) -> Matrix3<f64> {
        let Self { young: [along, across], poisson, shear, .. } = *self;
        let other = poisson * across / along;
        let (q, coupling) = (1.0 / (1.0 - poisson * other), poisson * across);
        Matrix3::new(along * q, coupling * q, 0.0, coupling * q, across * q, 0.0, 0.0, 0.0, shear)
    }

    /// Returns the stiffness in axes from which the fibres have an angle about the normal.
    ///
    /// Source: Jones (1999), Mechanics of composite materials, section 2.6.
    pub fn rotated(&self, angle: f64) -> Matrix3<f64> {
        let (s, c) = angle.sin_cos();
        let to_fibres = strain_transform([[c, s], [-s, c]]);
        to_fibres.transpose() * self.stiffness() * to_fibres
    }
}

/// Layer of a laminate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ply {
    /// Elastic constants.
    pub elasticity: PlyElasticity,
    /// Mass per volume.
    pub density: f64,
    /// Thickness.
    pub thickness: f64,
    /// Angle of the fibres from the first axis of the section, about the normal.
    pub angle: f64,
}

/// Layers of a shell from the lower side z = −h/2 to the upper side z = h/2, in the direction of the normal.
#[derive(Clone, Debug, PartialEq)]
pub struct Laminate {
    plies: Vec<Ply>,
}

impl Laminate {
    /// Creates a laminate of at least one ply.
    pub fn new(plies: Vec<Ply>) -> Self {
        Self { plies }
    }

    /// Returns the thickness h.
    pub fn thickness(&self) -> f64 {
        self.plies.iter().map(|ply| ply.thickness).sum()
    }

    /// Returns the plies with the heights of their lower and upper sides.
    fn heights(&self) -> impl Iterator<Item = (&Ply, [f64; 2])> {
        let mut low = -0.5 * self.thickness();
        self.plies.iter().map(move |ply| {
            let sides = [low, low + ply.thickness];
            low = sides[1];
            (ply, sides)
        })
    }

    /// Returns the stiffness and mass per area of the classical theory of laminates:
    /// A = Σ Q (z₁ − z₀), B = ½ Σ Q (z₁² − z₀²), D = ⅓ Σ Q (z₁³ − z₀³).
    pub fn section(&self) -> ShellSection {
        let [membrane, mut coupling, bending] = [1, 2, 3].map(|power: i32| {
            let part = |(ply, [low, high]): (&Ply, [f64; 2])| {
                let size = (high.powi(power) - low.powi(power)) / f64::from(power);
                ply.elasticity.rotated(ply.angle) * size
            };
            self.heights().map(part).sum::<Matrix3<f64>>()
        });
        // Symmetric laminates have no coupling: what remains are rounding errors.
        let size = membrane.amax() * self.thickness();
        coupling.iter_mut().filter(|b| b.abs() < 1e-13 * size).for_each(|b| *b = 0.0);
        let density = self.plies.iter().map(|ply| ply.density * ply.thickness).sum();
        let height = 0.5 * self.thickness();
        let surfaces = [height, 0.0, -height]
            .map(|height| SurfaceMaterial { height, stiffness: self.stiffness_at(height) });
        ShellSection { membrane, coupling, bending, density, surfaces, law: None }
    }

    /// Returns the section of a shear-deformable shell: S = ⅚ Σ Rᵀ diag(G_LZ, G_TZ) R (z₁ − z₀), the stiffness Σ E_T (z₁ − z₀) of
    /// the thickness, and the moments of the mass.
    pub fn thick_section(&self) -> ThickSection {
        let (mut shear, mut thickness, mut inertia) = (Matrix2::zeros(), 0.0, [0.0; 3]);
        for (ply, [low, high]) in self.heights() {
            let (sin, cos) = ply.angle.sin_cos();
            let to_fibres = Matrix2::new(cos, sin, -sin, cos);
            let [along, across] = ply.elasticity.transverse_shear;
            let own = to_fibres.transpose() * Matrix2::new(along, 0.0, 0.0, across) * to_fibres;
            shear += own * (SHEAR_CORRECTION * (high - low));
            thickness += ply.elasticity.young[1] * (high - low);
            for (power, sum) in (1..).zip(&mut inertia) {
                *sum += ply.density * (high.powi(power) - low.powi(power)) / f64::from(power);
            }
        }
        // The centre of mass of a symmetric laminate is in the middle: what remains are rounding errors.
        if inertia[1].abs() < 1e-13 * inertia[0] * self.thickness() {
            inertia[1] = 0.0;
        }
        ThickSection { surface: self.section(), shear, thickness, inertia }
    }

    /// Returns the height of the centre of mass.
    pub fn centre_of_mass(&self) -> f64 {
        let [mass, moment] = self.heights().fold([0.0; 2], |[mass, moment], (ply, [low, high])| {
            let own = ply.density * (high - low);
            [mass + own, moment + 0.5 * own * (low + high)]
        });
        moment / mass
    }

    /// Returns the stiffness of the ply at the height z. On the boundary of two plies it is the mean of both.
    fn stiffness_at(&self, z: f64) -> Matrix3<f64> {
        let near = ON_BOUNDARY * self.thickness();
        let at = self.heights().filter(|(_, [low, high])| (low - near..=high + near).contains(&z));
        let (sum, count) = at.fold((Matrix3::zeros(), 0.0), |(sum, count), (ply, _)| {
            (sum + ply.elasticity.rotated(ply.angle), count + 1.0)
        });
        sum / count
    }

    /// Returns the stresses at the height z, −h/2 ≤ z ≤ h/2, of the strains ε + z κ, in the axes of the section.
    ///
    /// They are those of the ply at this height. On the boundary of two plies, where the stresses jump, they are the means of both.
    /// The means do not depend on the direction of the normal.
    pub fn stress(&self, z: f64, membrane: &Vector3<f64>, curvature: &Vector3<f64>) -> Vector3<f64> {
        self.stiffness_at(z) * (membrane + curvature * z)
    }
}
