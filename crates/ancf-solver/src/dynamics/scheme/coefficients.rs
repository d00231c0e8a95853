use crate::equations::{State, Weights};
use crate::vectors::for_each_chunk_of;

/// Generalized-α scheme for index-3 equations, with Newmark and HHT as special cases.
///
/// Newmark's formulas apply to an auxiliary acceleration a. The equations of motion hold at the new time for the true
/// acceleration v̇:
///
/// qₙ₊₁ = qₙ + h vₙ + h² [(½ − β) aₙ + β aₙ₊₁],  vₙ₊₁ = vₙ + h [(1 − γ) aₙ + γ aₙ₊₁],
/// (1 − αm) aₙ₊₁ + αm aₙ = (1 − αf) v̇ₙ₊₁ + αf v̇ₙ.
///
/// The unknowns are (v̇ₙ₊₁, λₙ₊₁). aₙ approximates v̇ at tₙ + (αm − αf) h. For αm = αf = 0 both accelerations coincide
/// and the scheme is Newmark's. The order is two for γ = ½ + αf − αm and one otherwise. Larger γ causes strong damping.
///
/// Source: Arnold & Brüls (2007); Chung & Hulbert (1993); Newmark (1959), Kim et al. (2017), eq. (36), where vₙ₊₁
/// is misprinted for vₙ in the first formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SchemeCoefficients {
    /// Coefficient αm.
    pub alpha_m: f64,
    /// Coefficient αf.
    pub alpha_f: f64,
    /// Coefficient β. It is positive, since an explicit scheme leaves multipliers undetermined.
    pub beta: f64,
    /// Coefficient γ.
    pub gamma: f64,
    /// Numerical damping χ of the energy-momentum scheme; `None` for the other schemes.
    pub averaging: Option<f64>,
}

impl SchemeCoefficients {
    /// Newmark's scheme with γ = 0.70, β = 0.36, the values of ADAMS in Kim et al. (2017).
    pub const ADAMS: Self = Self::newmark(0.70, 0.36);
    /// Newmark's scheme with γ = 1/2, β = 1/4: the trapezoidal rule.
    pub const AVERAGE_ACCELERATION: Self = Self::newmark(0.5, 0.25);
    /// Newmark's scheme with γ = 1/2, β = 1/6. Unstable with constraints.
    pub const LINEAR_ACCELERATION: Self = Self::newmark(0.5, 1.0 / 6.0);

    /// Creates Newmark's scheme.
    pub const fn newmark(gamma: f64, beta: f64) -> Self {
        Self { alpha_m: 0.0, alpha_f: 0.0, beta, gamma, averaging: None }
    }

    /// Creates the energy-momentum scheme with the numerical damping χ ≥ 0.
    ///
    /// q₁ = q₀ + ½ h (v₀ + v₁) with the unknown mean acceleration v̇ = (v₁ − v₀)/h: Newmark's formulas with β = ½, γ = 1.
    /// The equations of motion are those of the step ([`Term::average_residual`]), of second order.
    ///
    /// Source: Simo & Tarnow (1992); Gonzalez (1996); Armero & Romero (2001) for χ.
    ///
    /// [`Term::average_residual`]: crate::equations::Term::average_residual
    pub const fn energy_momentum(damping: f64) -> Self {
        Self { averaging: Some(damping), ..Self::newmark(1.0, 0.5) }
    }

    /// Creates the scheme of Hilber, Hughes and Taylor: αf = −α, γ = ½ − α, β = (1 − α)²/4 for −1/3 ≤ α ≤ 0.
    ///
    /// Smaller α causes more damping.
    ///
    /// Source: Hilber, Hughes & Taylor (1977); for index-3 equations Negrut et al. (2007).
    pub const fn hht(alpha: f64) -> Self {
        Self::second_order(0.0, -alpha)
    }

    /// Creates the scheme with spectral radius ρ at infinite frequency: αm = (2ρ − 1)/(ρ + 1), αf = ρ/(ρ + 1) for 0 ≤ ρ
    /// ≤ 1.
    ///
    /// ρ = 1 gives no damping, and ρ = 0 annihilates the highest frequencies in one step. The damping of low
    /// frequencies is minimal for a given ρ.
    ///
    /// Source: Chung & Hulbert (1993).
    pub const fn generalized_alpha(spectral_radius: f64) -> Self {
        let rho = spectral_radius;
        Self::second_order((2.0 * rho - 1.0) / (rho + 1.0), rho / (rho + 1.0))
    }

    /// Sets γ = ½ + αf − αm for second order and β = ¼ (1 + αf − αm)² for maximum damping of high frequencies.
    const fn second_order(alpha_m: f64, alpha_f: f64) -> Self {
        let damping = alpha_f - alpha_m;
        let beta = 0.25 * (1.0 + damping) * (1.0 + damping);
        Self { alpha_m, alpha_f, beta, gamma: 0.5 + damping, averaging: None }
    }

    /// Returns true if the auxiliary acceleration equals the true one.
    pub const fn is_newmark(&self) -> bool {
        self.alpha_m == 0.0 && self.alpha_f == 0.0
    }

    /// Returns true if the scheme conserves the energy of linear vibrations, up to oscillations of it.
    pub const fn is_conservative(&self) -> bool {
        self.is_second_order() && self.gamma == 0.5
    }

    /// Returns the factor ρ by which a step multiplies velocities along constraints, which are errors.
    ///
    /// With Δq = 0, (v, h a) has the matrix [1 − γ/β, 1 − γ − (γ/β)(½ − β); −1/β, −(½ − β)/β]. ρ is its spectral radius.
    pub fn constrained_decay(&self) -> f64 {
        let Self { beta, gamma, .. } = *self;
        let (half, det) = (1.0 - 0.5 * (gamma + 0.5) / beta, 1.0 - (gamma - 0.5) / beta);
        let discriminant = half * half - det;
        // Rounding errors of a double eigenvalue.
        if discriminant <= 1e-12 { det.max(0.0).sqrt() } else { half.abs() + discriminant.sqrt() }
    }

    /// Returns true if γ = ½ + αf − αm, and for the energy-momentum scheme.
    pub const fn is_second_order(&self) -> bool {
        self.averaging.is_some() || (self.gamma - 0.5 - self.alpha_f + self.alpha_m).abs() < 1e-12
    }

    /// Returns αm − αf, the lead of the auxiliary over the true acceleration, in steps.
    pub const fn lead(&self) -> f64 {
        self.alpha_m - self.alpha_f
    }

    /// Returns C = 1/6 − (αm − αf)/2 − β. A step from exact values has the error C h³ v̈ in q.
    pub const fn error_constant(&self) -> f64 {
        1.0 / 6.0 - 0.5 * self.lead() - self.beta
    }

    /// Returns κ = ½ [β − 1/12 − g²/2 − g (αf + αm)/2], g = αf − αm.
    ///
    /// A second-order scheme maps the frequency ω to ω (1 − κ ω²h²).
    pub const fn phase_constant(&self) -> f64 {
        let g = -self.lead();
        0.5 * (self.beta - 1.0 / 12.0 - 0.5 * g * g - 0.5 * g * (self.alpha_f + self.alpha_m))
    }

    /// Returns dq : dv : da for an increment of the new true acceleration.
    pub const fn weights(&self, h: f64) -> Weights {
        let k = (1.0 - self.alpha_f) / (1.0 - self.alpha_m);
        Weights { q: k * self.beta * h * h, v: k * self.gamma * h, a: 1.0 }
    }

    /// Predicts the state after a step h with constant true acceleration; `auxiliary` is aₙ.
    pub fn predict(&self, s: &mut State, auxiliary: &[f64], h: f64) {
        for_each_chunk_of([&mut s.q, &mut s.v], |range, [q, v]| {
            for ((q, v), i) in q.iter_mut().zip(v).zip(range) {
                let a = auxiliary[i];
                let gain = h * (s.a[i] - a) / (1.0 - self.alpha_m); // h (aₙ₊₁ − aₙ)
                *q += h * (*v + 0.5 * h * a);
                *q += self.beta * h * gain;
                *v += h * a;
                *v += self.gamma * gain;
            }
        });
        s.t += h;
    }

    /// Returns aₙ₊₁ from aₙ, v̇ₙ and v̇ₙ₊₁.
    pub const fn auxiliary(&self, before: f64, true_before: f64, true_now: f64) -> f64 {
        ((1.0 - self.alpha_f) * true_now + self.alpha_f * true_before - self.alpha_m * before)
            / (1.0 - self.alpha_m)
    }
}
