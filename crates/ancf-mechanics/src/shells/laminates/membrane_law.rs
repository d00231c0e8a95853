use nalgebra::{Matrix3, Vector3};

/// Energy per area of the membrane strains of an isotropic shell, as a function of Green's strains.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MembraneEnergy {
    /// St. Venant-Kirchhoff law in plane stress: ½ E h/(1 − ν²) (e₁² + e₂² + 2 ν e₁ e₂).
    Linear {
        /// E h, force/length.
        stiffness: f64,
        /// Poisson's ratio ν.
        poisson: f64,
    },
    /// Incompressible neo-Hookean law: ½ G h (λ₁² + λ₂² + 1/(λ₁ λ₂)² − 3).
    NeoHookean {
        /// G h, force/length.
        stiffness: f64,
    },
}

/// Law of the membrane forces of an isotropic shell, n = ∂W/∂ε.
///
/// A tension field has no compressive force. Where the smaller principal force of W would be negative, the membrane is wrinkled and has
/// the energy of uniaxial tension; without tension in any direction it is slack. The relaxed energy W_r is convex in the strains.
/// A part c of the energy W remains, (1 − c) W_r + c W, so that the stiffness is positive.
///
/// Source: Pipkin (1986), relaxed energies of membranes; Steigmann (1990), tension-field theory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MembraneLaw {
    /// Energy W of the flat membrane.
    pub energy: MembraneEnergy,
    /// Part c of the energy W that remains in a tension field; `None` without wrinkles.
    pub tension_field: Option<f64>,
}

/// Energy, forces and stiffness of a state of strain.
#[derive(Clone, Copy, Debug)]
pub struct MembraneState {
    /// Energy W per area.
    pub energy: f64,
    /// Forces (11, 22, 12), force/length.
    pub force: Vector3<f64>,
    /// Stiffness ∂n/∂ε of the strains (11, 22, 2·12).
    pub stiffness: Matrix3<f64>,
}

/// State in the directions of the principal strains e₁ ≥ e₂.
#[derive(Clone, Copy, Debug, Default)]
struct PrincipalState {
    energy: f64,
    force: [f64; 2],
    /// ∂n₁/∂e₁, ∂n₁/∂e₂ and ∂n₂/∂e₂.
    stiffness: [f64; 3],
    /// (n₁ − n₂)/(e₁ − e₂).
    shear: f64,
}

impl PrincipalState {
    /// State of uniaxial tension.
    fn uniaxial(energy: f64, force: f64, stiffness: f64, [e1, e2]: [f64; 2]) -> Self {
        Self { energy, force: [force, 0.0], stiffness: [stiffness, 0.0, 0.0], shear: force / (e1 - e2) }
    }

    fn mixed(&self, share: f64, other: &Self) -> Self {
        let mix = |a: f64, b: f64| (1.0 - share) * a + share * b;
        Self {
            energy: mix(self.energy, other.energy),
            force: [0, 1].map(|k| mix(self.force[k], other.force[k])),
            stiffness: [0, 1, 2].map(|k| mix(self.stiffness[k], other.stiffness[k])),
            shear: mix(self.shear, other.shear),
        }
    }
}

impl MembraneEnergy {
    /// Returns the energy of a multiple of the thickness.
    fn scaled(self, scale: f64) -> Self {
        match self {
            Self::Linear { stiffness, poisson } => Self::Linear { stiffness: scale * stiffness, poisson },
            Self::NeoHookean { stiffness } => Self::NeoHookean { stiffness: scale * stiffness },
        }
    }

    /// State of a flat membrane.
    fn flat(&self, [e1, e2]: [f64; 2]) -> PrincipalState {
        match *self {
            Self::Linear { stiffness, poisson } => {
                let a = stiffness / (1.0 - poisson * poisson);
                PrincipalState {
                    energy: 0.5 * a * (e1 * e1 + e2 * e2 + 2.0 * poisson * e1 * e2),
                    force: [a * (e1 + poisson * e2), a * (e2 + poisson * e1)],
                    stiffness: [a, a * poisson, a],
                    shear: a * (1.0 - poisson),
                }
            }
            Self::NeoHookean { stiffness: g } => {
                let [c1, c2] = [e1, e2].map(|e| if e > -0.5 { 1.0 + 2.0 * e } else { f64::NAN });
                let d = c1 * c2;
                // c₁ + c₂ + 1/d − 3 and c² c' − 1 without cancellation at small strains.
                let (sum, product) = (2.0 * (e1 + e2), 4.0 * e1 * e2);
                let force = |c: f64, e: f64, other: f64| {
                    g * (1.0 + 2.0 * other) * (4.0 * e + 4.0 * e * e + 2.0 * other * c * c) / (d * d)
                };
                let cross = 2.0 * g / (d * d);
                PrincipalState {
                    energy: 0.5 * g * (sum * (sum + product) - product) / d,
                    force: [force(c1, e1, e2), force(c2, e2, e1)],
                    stiffness: [4.0 * g * c2 * c2 / d.powi(3), cross, 4.0 * g * c1 * c1 / d.powi(3)],
                    shear: cross,
                }
            }
        }
    }

    /// State of a membrane that cannot bear compression.
    fn relaxed(&self, [e1, e2]: [f64; 2]) -> PrincipalState {
        let flat = self.flat([e1, e2]);
        // Without strain the membrane has the stiffness of tension, from which iterations start.
        if flat.force[1] >= 0.0 {
            return flat;
        }
        if e1 <= 0.0 {
            return PrincipalState::default();
        }
        match *self {
            Self::Linear { stiffness, .. } => {
                PrincipalState::uniaxial(0.5 * stiffness * e1 * e1, stiffness * e1, stiffness, [e1, e2])
            }
            Self::NeoHookean { stiffness: g } => {
                let c: f64 = 1.0 + 2.0 * e1;
                let stretch = c.sqrt();
                // λ² + 2/λ − 3 = (λ − 1)² (λ + 2)/λ
                let energy = 0.5 * g * (2.0 * e1 / (1.0 + stretch)).powi(2) * (stretch + 2.0) / stretch;
                let force = -g * (-1.5 * (2.0 * e1).ln_1p()).exp_m1();
                PrincipalState::uniaxial(energy, force, 3.0 * g / (c * c * stretch), [e1, e2])
            }
        }
    }
}

impl MembraneLaw {
    /// Returns the law of a multiple of the thickness.
    pub(crate) fn scaled(self, scale: f64) -> Self {
        Self { energy: self.energy.scaled(scale), ..self }
    }

    /// Returns the state of the strains (11, 22, 2·12) in an orthonormal basis.
    pub fn state(&self, strain: &Vector3<f64>) -> MembraneState {
        let (mean, half) = (0.5 * (strain.x + strain.y), 0.5 * (strain.x - strain.y));
        let radius = half.hypot(0.5 * strain.z);
        let principal = [mean + radius, mean - radius];
        let angle = 0.5 * (0.5 * strain.z).atan2(half);
        let own = match self.tension_field {
            None => self.energy.flat(principal),
            Some(share) => self.energy.relaxed(principal).mixed(share, &self.energy.flat(principal)),
        };
        let (sin, cos) = angle.sin_cos();
        let first = Vector3::new(cos * cos, sin * sin, sin * cos);
        let second = Vector3::new(sin * sin, cos * cos, -sin * cos);
        let [a, b, c] = own.stiffness;
        let stiffness = first * first.transpose() * a
            + (first * second.transpose() + second * first.transpose()) * b
            + second * second.transpose() * c;
        // Shear strain ε₁₂ in the principal directions, which turns these.
        let turn = Vector3::new(-sin * cos, sin * cos, 0.5 * (cos * cos - sin * sin));
        MembraneState {
            energy: own.energy,
            force: first * own.force[0] + second * own.force[1],
            stiffness: stiffness + turn * turn.transpose() * (2.0 * own.shear),
        }
    }
}
