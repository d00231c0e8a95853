use nalgebra::Vector3;

use super::laminates::{ShellSection, strain_transform};

/// Names of the surfaces at which stresses are computed: at +h/2 along the normal, in the middle, and at −h/2.
pub const LAYERS: [&str; 3] = ["top", "middle", "bottom"];

/// Returns Green's strain (ξξ, ηη, 2 ξη) of tangents a of the reference surface with the derivatives u of displacements:
/// ε_αβ = ½ (a_α·u_β + u_α·a_β + u_α·u_β).
pub(crate) fn membrane_strain([a, u]: [[Vector3<f64>; 2]; 2]) -> Vector3<f64> {
    Vector3::new(
        (a[0] + u[0] * 0.5).dot(&u[0]),
        (a[1] + u[1] * 0.5).dot(&u[1]),
        a[0].dot(&u[1]) + u[0].dot(&a[1]) + u[0].dot(&u[1]),
    )
}

/// Returns the rate of Green's strain (ξξ, ηη, 2 ξη) of tangents with their rates.
pub(crate) fn membrane_rate([tangents, rates]: [[Vector3<f64>; 2]; 2]) -> Vector3<f64> {
    let [[t, s], [dt, ds]] = [tangents, rates];
    Vector3::new(t.dot(&dt), s.dot(&ds), t.dot(&ds) + s.dot(&dt))
}

/// Membrane strains and changes of curvature at a point, in an orthonormal frame.
pub(crate) type SurfaceStrains = [Vector3<f64>; 2];

/// Strains that determine the stresses of a shell at a point.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct PointStrains {
    /// Strains with the prescribed ones.
    pub(crate) total: SurfaceStrains,
    /// Prescribed strains.
    pub(crate) prescribed: SurfaceStrains,
    /// Rates of the strains less the prescribed ones, times the retardation time.
    pub(crate) retarded: SurfaceStrains,
}

impl PointStrains {
    /// Adds a multiple of the strains and retarded strains of an element, and of its prescribed strains and their retarded rates.
    pub(crate) fn add(&mut self, factor: f64, own: &[SurfaceStrains; 2], prescribed: &[SurfaceStrains; 2]) {
        for k in 0..2 {
            self.total[k] += own[0][k] * factor;
            self.prescribed[k] += prescribed[0][k] * factor;
            self.retarded[k] += (own[1][k] - prescribed[1][k]) * factor;
        }
    }
}

/// Strains, resultants and stresses of a shell at a point, with those of the damping.
///
/// Components are (11, 22, 12) in the orthonormal frame of the reference surface: e₁ along r_,u, e₂ = n × e₁, also if the fibres of
/// a laminate refer to another axis. Stresses are of
/// second Piola-Kirchhoff, which rotations leave unchanged. For small strains they are those in the frame that rotates with the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceStress {
    /// Membrane strains ε₁₁, ε₂₂, 2 ε₁₂, with the prescribed ones.
    pub strain: Vector3<f64>,
    /// Changes of curvature κ₁₁, κ₂₂, 2 κ₁₂, positive for tension at the top, with the prescribed ones.
    pub curvature: Vector3<f64>,
    /// Membrane forces n = A (ε − ε⁰) + B (κ − κ⁰), force per length.
    pub force: Vector3<f64>,
    /// Moments m = B (ε − ε⁰) + D (κ − κ⁰), moment per length, positive for tension at the top.
    pub moment: Vector3<f64>,
    /// Strain energy per area.
    energy: f64,
    /// Stresses at the surfaces [`LAYERS`].
    pub layers: [Vector3<f64>; 3],
}

/// Returns cosine and sine of the angle about a unit normal from the projection of one axis to that of another.
pub(crate) fn direction([from, to]: [&Vector3<f64>; 2], normal: &Vector3<f64>) -> [f64; 2] {
    let e1 = (from - normal * from.dot(normal)).normalize();
    let components = [to.dot(&e1), to.dot(&normal.cross(&e1))];
    let length = components[0].hypot(components[1]);
    components.map(|x| x / length)
}

impl SurfaceStress {
    /// Computes resultants and stresses by the law of a section, whose first direction has the given cosine and sine in (e₁, e₂). Stresses of
    /// the damping are those of the linear law.
    ///
    /// The stresses of a laminate are those of the ply at each surface; those in the middle are the means of both plies if it is
    /// the boundary of two.
    pub(crate) fn new(
        section: &ShellSection,
        [cos, sin]: [f64; 2],
        PointStrains { total: [strain, curvature], prescribed, retarded }: PointStrains,
    ) -> Self {
        let to_section = strain_transform([[cos, sin], [-sin, cos]]);
        let elastic = [strain - prescribed[0], curvature - prescribed[1]];
        let [own, bent, slow, slowly_bent] =
            [elastic[0], elastic[1], retarded[0], retarded[1]].map(|x| to_section * x);
        // The transposed matrix transforms the components of stresses.
        let back = |stress: Vector3<f64>| to_section.transpose() * stress;
        let resultants = |own: Vector3<f64>, bent: Vector3<f64>| {
            (
                section.membrane * own + section.coupling * bent,
                section.coupling * own + section.bending * bent,
            )
        };
        let ((force, moment), (slow_force, slow_moment)) =
            (resultants(own, bent), resultants(slow, slowly_bent));
        let slow_layers = section.surfaces.map(|at| at.stiffness * (slow + slowly_bent * at.height));
        let mut found = Self {
            strain,
            curvature,
            force: back(force + slow_force),
            moment: back(moment + slow_moment),
            energy: 0.5 * (force.dot(&own) + moment.dot(&bent)),
            layers: std::array::from_fn(|k| {
                let at = &section.surfaces[k];
                back(at.stiffness * (own + bent * at.height) + slow_layers[k])
            }),
        };
        if let Some(law) = &section.law {
            let [total, free] = [strain, prescribed[0]].map(|strain| to_section * strain);
            let state = law.strained_state([&total, &free]);
            let thickness = section.surfaces[0].height - section.surfaces[2].height;
            found.force = back(state.force + slow_force);
            found.energy = state.energy + 0.5 * moment.dot(&bent);
            found.layers = std::array::from_fn(|k| {
                let at = &section.surfaces[k];
                back(state.force / thickness + at.stiffness * bent * at.height + slow_layers[k])
            });
        }
        found
    }

    /// Returns the equivalent stress of von Mises at the surfaces [`LAYERS`]: √(σ₁₁² − σ₁₁ σ₂₂ + σ₂₂² + 3 σ₁₂²) in plane stress.
    pub fn von_mises(&self) -> [f64; 3] {
        self.layers.map(|s| (s.x * s.x - s.x * s.y + s.y * s.y + 3.0 * s.z * s.z).sqrt())
    }

    /// Returns the larger equivalent stress of both faces. Inner plies of a laminate may have a larger one.
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

    /// Returns the strain energy per area: ½ (n·(ε − ε⁰) + m·(κ − κ⁰)), with another law of the membrane its energy in place of the first part.
    pub const fn energy(&self) -> f64 {
        self.energy
    }
}
