use crate::system::{State, Weights};

/// Newmark's scheme for index-3 equations: the residual is satisfied at the new time, with
///
/// qₙ₊₁ = qₙ + h vₙ + h² [(½ − β) aₙ + β aₙ₊₁],  vₙ₊₁ = vₙ + h [(1 − γ) aₙ + γ aₙ₊₁]
///
/// and unknowns (aₙ₊₁, λₙ₊₁). Second order for γ = ½, else first; γ > ½ damps.
///
/// Source: Newmark (1959); Kim et al. (2017), eq. (36), where vₙ₊₁ is misprinted for vₙ in the first formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Newmark {
    /// γ.
    pub gamma: f64,
    /// β; positive, since an explicit scheme leaves multipliers undetermined.
    pub beta: f64,
}

impl Newmark {
    /// γ = 0.70, β = 0.36: the values of ADAMS that Kim et al. (2017) use.
    pub const ADAMS: Self = Self { gamma: 0.70, beta: 0.36 };
    /// γ = 1/2, β = 1/4: the trapezoidal rule.
    pub const AVERAGE_ACCELERATION: Self = Self { gamma: 0.5, beta: 0.25 };
    /// γ = 1/2, β = 1/6.
    pub const LINEAR_ACCELERATION: Self = Self { gamma: 0.5, beta: 1.0 / 6.0 };

    /// dq : dv : da for an increment of the new acceleration.
    pub fn weights(&self, h: f64) -> Weights {
        Weights { q: self.beta * h * h, v: self.gamma * h, a: 1.0 }
    }

    /// Moves a state on by h as if its acceleration stayed.
    pub fn predict(&self, s: &mut State, h: f64) {
        for i in 0..s.q.len() {
            s.q[i] += h * (s.v[i] + 0.5 * h * s.a[i]);
            s.v[i] += h * s.a[i];
        }
        s.t += h;
    }
}
