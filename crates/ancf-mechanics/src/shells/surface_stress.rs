use nalgebra::Vector3;

use super::section::ShellSection;

/// Names of the surfaces at which stresses are computed: at +h/2 along the normal, in the middle, and at −h/2.
pub const LAYERS: [&str; 3] = ["top", "middle", "bottom"];

/// Strains, resultants and stresses of a shell at a point.
///
/// Components are (11, 22, 12) in the orthonormal frame of the reference surface: e₁ along r_,u, e₂ = n × e₁. Stresses are of
/// second Piola-Kirchhoff, which rotations leave unchanged. For small strains they are those in the frame that rotates with the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceStress {
    /// Membrane strains ε₁₁, ε₂₂, 2 ε₁₂.
    pub strain: Vector3<f64>,
    /// Changes of curvature κ₁₁, κ₂₂, 2 κ₁₂, positive for tension at the top.
    pub curvature: Vector3<f64>,
    /// Membrane forces n = A ε + B κ, force per length.
    pub force: Vector3<f64>,
    /// Moments m = B ε + D κ, moment per length, positive for tension at the top.
    pub moment: Vector3<f64>,
    /// Stresses at the surfaces [`LAYERS`].
    pub layers: [Vector3<f64>; 3],
}

impl SurfaceStress {
    /// Computes resultants and stresses by the law of a section.
    pub(crate) fn new(section: &ShellSection, strain: Vector3<f64>, curvature: Vector3<f64>) -> Self {
        Self {
            strain,
            curvature,
            force: section.membrane * strain + section.coupling * curvature,
            moment: section.coupling * strain + section.bending * curvature,
            layers: section.layer_stresses(&strain, &curvature),
        }
    }

    /// Returns the equivalent stress of von Mises at the surfaces [`LAYERS`]: √(σ₁₁² − σ₁₁ σ₂₂ + σ₂₂² + 3 σ₁₂²) in plane stress.
    pub fn von_mises(&self) -> [f64; 3] {
        self.layers.map(|s| (s.x * s.x - s.x * s.y + s.y * s.y + 3.0 * s.z * s.z).sqrt())
    }

    /// Returns the larger equivalent stress of both faces.
    pub fn largest_von_mises(&self) -> f64 {
        let [top, _, bottom] = self.von_mises();
        top.max(bottom)
    }

    /// Returns the principal stresses σ₁ ≥ σ₂ at the surfaces [`LAYERS`], and the angle from e₁ to the direction of σ₁ in radians.
    pub fn principal(&self) -> [[f64; 3]; 3] {
        self.layers.map(|s| {
            let (mean, half) = (0.5 * (s.x + s.y), 0.5 * (s.x - s.y));
            let radius = half.hypot(s.z);
            [mean + radius, mean - radius, 0.5 * s.z.atan2(half)]
        })
    }

    /// Returns the strain energy per area, ½ (n·ε + m·κ).
    pub fn energy(&self) -> f64 {
        0.5 * (self.force.dot(&self.strain) + self.moment.dot(&self.curvature))
    }
}

impl ShellSection {
    /// Computes the stresses at the surfaces [`LAYERS`] of a homogeneous section: C (ε + z κ) at z = h/2, 0, −h/2.
    ///
    /// Its matrices are A = C h and D = C h³/12.
    pub fn layer_stresses(&self, strain: &Vector3<f64>, curvature: &Vector3<f64>) -> [Vector3<f64>; 3] {
        let thickness = (12.0 * self.bending[(0, 0)] / self.membrane[(0, 0)]).sqrt();
        let stress = |height: f64| self.membrane * (strain + curvature * (height * thickness)) / thickness;
        [0.5, 0.0, -0.5].map(stress)
    }
}
