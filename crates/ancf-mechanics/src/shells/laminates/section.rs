use nalgebra::{Matrix2, Matrix3, Vector3};

use super::membrane_law::MembraneLaw;

/// Stiffness of a shell per area: n = A ε + B κ, m = B ε + D κ, and its mass per area.
///
/// Strains and curvatures are (11, 22, 2·12) in an orthonormal basis of the reference surface, whose first direction is that of
/// r_ξ or of a given axis ([`ShellMedium`](crate::shells::ShellMedium)). Curvatures are positive for tension at the side of the normal
/// r_ξ × r_η: the strain at the height z is ε + z κ.
///
/// Units: A force/length, B force, D force length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShellSection {
    /// Membrane stiffness A.
    pub membrane: Matrix3<f64>,
    /// Coupling B, symmetric.
    pub coupling: Matrix3<f64>,
    /// Bending stiffness D.
    pub bending: Matrix3<f64>,
    /// Mass per area.
    pub density: f64,
    /// Material at the surfaces [`LAYERS`](crate::shells::LAYERS).
    pub surfaces: [SurfaceMaterial; 3],
    /// Law of the membrane forces in place of A ε, of a homogeneous isotropic shell.
    pub law: Option<MembraneLaw>,
}

/// Material of a shell at a height: the stress is C (ε + z κ).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceMaterial {
    /// Height z above the middle surface.
    pub height: f64,
    /// Stiffness C in plane stress, force/area.
    pub stiffness: Matrix3<f64>,
}

impl ShellSection {
    /// Creates the section of a homogeneous isotropic shell in plane stress.
    ///
    /// A = E h/(1 − ν²) \[1 ν 0; ν 1 0; 0 0 (1 − ν)/2\], D = A h²/12.
    pub fn isotropic(young: f64, poisson: f64, density: f64, thickness: f64) -> Self {
        let q = young / (1.0 - poisson * poisson);
        let plane =
            Matrix3::new(q, q * poisson, 0.0, q * poisson, q, 0.0, 0.0, 0.0, 0.5 * young / (1.0 + poisson));
        Self {
            membrane: plane * thickness,
            coupling: Matrix3::zeros(),
            bending: plane * (thickness.powi(3) / 12.0),
            density: density * thickness,
            surfaces: [0.5, 0.0, -0.5]
                .map(|part| SurfaceMaterial { height: part * thickness, stiffness: plane }),
            law: None,
        }
    }

    /// Returns the section with another law of the membrane forces.
    #[must_use]
    pub fn with_law(self, law: Option<MembraneLaw>) -> Self {
        Self { law, ..self }
    }

    /// Returns the section whose thickness is a multiple c of this one: c A, c² B, c³ D, with plies of c times the thickness.
    #[must_use]
    pub fn scaled(&self, scale: f64) -> Self {
        let square = scale * scale;
        let surface = |at: SurfaceMaterial| SurfaceMaterial { height: scale * at.height, ..at };
        Self {
            membrane: self.membrane * scale,
            coupling: self.coupling * square,
            bending: self.bending * (square * scale),
            density: self.density * scale,
            surfaces: self.surfaces.map(surface),
            law: self.law.map(|law| law.scaled(scale)),
        }
    }

    /// Returns the matrices A, B and D for the covariant components (ξξ, ηη, 2 ξη) of strains.
    ///
    /// `tangents` are r_ξ and r_η in the reference state. The first direction of the section is that of the projection of `axis`.
    pub(crate) fn covariant(
        &self,
        tangents: [&Vector3<f64>; 2],
        axis: Option<Vector3<f64>>,
    ) -> [Matrix3<f64>; 3] {
        let to_local = to_orthonormal(tangents, &axis.unwrap_or(*tangents[0]));
        [self.membrane, self.coupling, self.bending].map(|c| to_local.transpose() * c * to_local)
    }
}

/// Returns the matrix from covariant components (ξξ, ηη, 2 ξη) of strains to those in an orthonormal basis.
///
/// `t` and `s` are the reference tangents r_ξ and r_η. The first direction of the basis is that of the projection of `axis`.
pub(crate) fn to_orthonormal([t, s]: [&Vector3<f64>; 2], axis: &Vector3<f64>) -> Matrix3<f64> {
    let normal = t.cross(s);
    let unit = normal.normalize();
    let e1 = (axis - unit * axis.dot(&unit)).normalize();
    let e2 = unit.cross(&e1);
    // Contravariant basis: e_i = (e_i·A_α) A^α, so ε_ij = ε_αβ (e_i·A^α)(e_j·A^β).
    let area = normal.norm();
    let (a1, a2) = (s.cross(&normal) / (area * area), normal.cross(t) / (area * area));
    strain_transform([[e1.dot(&a1), e1.dot(&a2)], [e2.dot(&a1), e2.dot(&a2)]])
}

/// Returns the symmetric tensor of strains (11, 22, 2·12).
pub(crate) fn strain_tensor(e: &Vector3<f64>) -> Matrix2<f64> {
    Matrix2::new(e.x, 0.5 * e.z, 0.5 * e.z, e.y)
}

/// Returns the components (11, 22, 2·12) of the symmetric part of a tensor.
pub(crate) fn strain_components(e: &Matrix2<f64>) -> Vector3<f64> {
    Vector3::new(e.m11, e.m22, e.m12 + e.m21)
}

/// Returns the matrix of the components (11, 22, 2·12) of strains for a change of basis with e_i = Σ c_iα a_α.
pub(crate) fn strain_transform([[c11, c12], [c21, c22]]: [[f64; 2]; 2]) -> Matrix3<f64> {
    Matrix3::new(
        c11 * c11,
        c12 * c12,
        c11 * c12,
        c21 * c21,
        c22 * c22,
        c21 * c22,
        2.0 * c11 * c21,
        2.0 * c12 * c22,
        c11 * c22 + c12 * c21,
    )
}
