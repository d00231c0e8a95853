use crate::equations::{State, Weights};

/// The generalized-α scheme for index-3 equations, of which Newmark's and HHT are special cases.
///
/// Newmark's formulas act on an auxiliary acceleration a, while the equations of motion hold at the new time for the
/// true one, v̇:
///
/// qₙ₊₁ = qₙ + h vₙ + h² [(½ − β) aₙ + β aₙ₊₁],  vₙ₊₁ = vₙ + h [(1 − γ) aₙ + γ aₙ₊₁],
/// (1 − αm) aₙ₊₁ + αm aₙ = (1 − αf) v̇ₙ₊₁ + αf v̇ₙ.
///
/// The unknowns are (v̇ₙ₊₁, λₙ₊₁). aₙ approximates v̇ at tₙ + (αm − αf) h; with αm = αf = 0 the two are one and the scheme
/// is Newmark's. Second order for γ = ½ + αf − αm, else first; γ beyond that damps strongly.
///
/// Source: Arnold & Brüls (2007); Chung & Hulbert (1993); Newmark (1959), Kim et al. (2017), eq. (36), where vₙ₊₁
/// is misprinted for vₙ in the first formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scheme {
    /// αm.
    pub alpha_m: f64,
    /// αf.
    pub alpha_f: f64,
    /// β; positive, since an explicit scheme leaves multipliers undetermined.
    pub beta: f64,
    /// γ.
    pub gamma: f64,
}

impl Scheme {
    /// Newmark's scheme with γ = 0.70, β = 0.36: the values of ADAMS that Kim et al. (2017) use.
    pub const ADAMS: Self = Self::newmark(0.70, 0.36);
    /// Newmark's scheme with γ = 1/2, β = 1/4: the trapezoidal rule.
    pub const AVERAGE_ACCELERATION: Self = Self::newmark(0.5, 0.25);
    /// Newmark's scheme with γ = 1/2, β = 1/6; not stable with constraints.
    pub const LINEAR_ACCELERATION: Self = Self::newmark(0.5, 1.0 / 6.0);

    /// Newmark's scheme.
    pub const fn newmark(gamma: f64, beta: f64) -> Self {
        Self { alpha_m: 0.0, alpha_f: 0.0, beta, gamma }
    }

    /// The scheme of Hilber, Hughes and Taylor, −1/3 ≤ α ≤ 0: αf = −α, γ = ½ − α, β = (1 − α)²/4. The smaller α, the more damping.
    ///
    /// Source: Hilber, Hughes & Taylor (1977); for index-3 equations Negrut et al. (2007).
    pub const fn hht(alpha: f64) -> Self {
        Self::second_order(0.0, -alpha)
    }

    /// The scheme whose spectral radius at infinite frequency is ρ, 0 ≤ ρ ≤ 1: αm = (2ρ − 1)/(ρ + 1), αf = ρ/(ρ + 1).
    ///
    /// ρ = 1 damps nothing, ρ = 0 ends the highest frequencies in one step; low ones are damped least for a given ρ.
    ///
    /// Source: Chung & Hulbert (1993).
    pub const fn generalized_alpha(spectral_radius: f64) -> Self {
        let rho = spectral_radius;
        Self::second_order((2.0 * rho - 1.0) / (rho + 1.0), rho / (rho + 1.0))
    }

    /// γ = ½ + αf − αm and β = ¼ (1 + αf − αm)²: second order and, of such, most damping at high frequencies.
    const fn second_order(alpha_m: f64, alpha_f: f64) -> Self {
        let damping = alpha_f - alpha_m;
        Self { alpha_m, alpha_f, beta: 0.25 * (1.0 + damping) * (1.0 + damping), gamma: 0.5 + damping }
    }

    /// Whether the auxiliary acceleration is the true one.
    pub const fn is_newmark(&self) -> bool {
        self.alpha_m == 0.0 && self.alpha_f == 0.0
    }

    /// Whether γ = ½ + αf − αm.
    pub const fn is_second_order(&self) -> bool {
        (self.gamma - 0.5 - self.alpha_f + self.alpha_m).abs() < 1e-12
    }

    /// αm − αf: by so many steps the auxiliary acceleration is ahead of the true one.
    pub const fn lead(&self) -> f64 {
        self.alpha_m - self.alpha_f
    }

    /// C = 1/6 − (αm − αf)/2 − β: a step leaves the error C h³ v̈ in q if it starts from exact values.
    pub const fn error_constant(&self) -> f64 {
        1.0 / 6.0 - 0.5 * self.lead() - self.beta
    }

    /// κ = ½ [β − 1/12 − g²/2 − g (αf + αm)/2], g = αf − αm: a second-order scheme turns the frequency ω into ω (1 − κ ω²h²).
    pub const fn phase_constant(&self) -> f64 {
        let g = -self.lead();
        0.5 * (self.beta - 1.0 / 12.0 - 0.5 * g * g - 0.5 * g * (self.alpha_f + self.alpha_m))
    }

    /// dq : dv : da for an increment of the new true acceleration.
    pub const fn weights(&self, h: f64) -> Weights {
        let k = (1.0 - self.alpha_f) / (1.0 - self.alpha_m);
        Weights { q: k * self.beta * h * h, v: k * self.gamma * h, a: 1.0 }
    }

    /// Moves a state on by h as if its true acceleration stayed; `auxiliary` is aₙ.
    pub fn predict(&self, s: &mut State, auxiliary: &[f64], h: f64) {
        for (i, &a) in auxiliary.iter().enumerate() {
            let gain = h * (s.a[i] - a) / (1.0 - self.alpha_m); // h (aₙ₊₁ − aₙ)
            s.q[i] += h * (s.v[i] + 0.5 * h * a);
            s.q[i] += self.beta * h * gain;
            s.v[i] += h * a;
            s.v[i] += self.gamma * gain;
        }
        s.t += h;
    }

    /// aₙ₊₁ from aₙ, v̇ₙ and v̇ₙ₊₁.
    pub const fn auxiliary(&self, before: f64, true_before: f64, true_now: f64) -> f64 {
        ((1.0 - self.alpha_f) * true_now + self.alpha_f * true_before - self.alpha_m * before)
            / (1.0 - self.alpha_m)
    }
}
