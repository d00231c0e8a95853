use nalgebra::{Matrix3, Vector3};

/// Stiffness of a shell per area: n = A ε + B κ, m = B ε + D κ, and its mass per area.
///
/// Strains and curvatures are (11, 22, 2·12) in an orthonormal basis of the reference surface, whose first direction is that of
/// r_ξ. Curvatures are positive for tension at the side of the normal r_ξ × r_η: the strain at the height z is ε + z κ.
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
        }
    }

    /// Returns the matrices A, B and D for the covariant components (ξξ, ηη, 2 ξη) of strains.
    ///
    /// `t` and `s` are the reference tangents r_ξ and r_η.
    pub(crate) fn covariant(&self, t: &Vector3<f64>, s: &Vector3<f64>) -> [Matrix3<f64>; 3] {
        let to_local = to_orthonormal(t, s);
        [self.membrane, self.coupling, self.bending].map(|c| to_local.transpose() * c * to_local)
    }
}

/// Returns the matrix from covariant components (ξξ, ηη, 2 ξη) of strains to those in the orthonormal basis of a section.
///
/// `t` and `s` are the reference tangents r_ξ and r_η.
pub(crate) fn to_orthonormal(t: &Vector3<f64>, s: &Vector3<f64>) -> Matrix3<f64> {
    let normal = t.cross(s);
    let e1 = t.normalize();
    let e2 = normal.normalize().cross(&e1);
    // Contravariant basis: e_i = (e_i·A_α) A^α, so ε_ij = ε_αβ (e_i·A^α)(e_j·A^β).
    let area = normal.norm();
    let (a1, a2) = (s.cross(&normal) / (area * area), normal.cross(t) / (area * area));
    let (c11, c12) = (e1.dot(&a1), e1.dot(&a2));
    let (c21, c22) = (e2.dot(&a1), e2.dot(&a2));
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
