use ancf_solver::equations::LocalStep;

use crate::laws::{LawValue, Resistance};

/// Law of the tensile force of a strut by its change of length x and its rate.
#[derive(Clone, Debug)]
pub enum StrutLaw {
    /// Spring with a damper.
    Linear(LinearStrut),
    /// General law.
    General(Resistance),
}

/// Spring with a damper: N = k e + c dl/dt, e = x − s (L₀ − l₀) for the free length L₀.
///
/// The load factor s, which differs from 1 in statics only, scales the preload. A rope has no compression: N = 0 for e ≤ 0,
/// and N ≥ 0 otherwise. U = ½ k e² minus its reference value.
///
/// Units: k force/length, c force × time/length.
#[derive(Clone, Debug, Default)]
pub struct LinearStrut {
    pub(crate) stiffness: f64,
    pub(crate) damping: f64,
    /// Preload length L₀ − l₀.
    pub(crate) preload_length: f64,
    pub(crate) rope: bool,
}

impl From<LinearStrut> for StrutLaw {
    fn from(law: LinearStrut) -> Self {
        Self::Linear(law)
    }
}

impl From<Resistance> for StrutLaw {
    fn from(law: Resistance) -> Self {
        Self::General(law)
    }
}

impl LinearStrut {
    /// Returns e at a change of length and a load factor. It is 0 for a slack rope.
    fn stretch(&self, change: f64, load: f64) -> f64 {
        let stretch = change - load * self.preload_length;
        if self.rope { stretch.max(0.0) } else { stretch }
    }

    fn at(&self, change: f64, rate: f64, load: f64) -> LawValue {
        let stretch = self.stretch(change, load);
        let force = self.stiffness * stretch + self.damping * rate;
        let acts = !self.rope || (stretch > 0.0 && force > 0.0);
        let value = LawValue { force, by_position: self.stiffness, by_rate: self.damping };
        if acts { value } else { LawValue::default() }
    }

    /// Returns the elastic force of a step, ΔU/Δx for χ = 0.
    fn of_step(&self, ends: [f64; 2], step: &LocalStep<'_>) -> f64 {
        let [before, now] = ends.map(|change| self.stretch(change, step.middle.load));
        let moved = ends[1] - ends[0];
        // Part of the step in which a rope is tight.
        let tight = if before > 0.0 && now > 0.0 || !self.rope {
            1.0
        } else {
            ((now - before) / moved).clamp(0.0, 1.0)
        };
        let [start, end] = step.shares();
        if before == 0.0 && now == 0.0 {
            0.0
        } else {
            self.stiffness * tight * (start * before + end * now).max(if self.rope { 0.0 } else { f64::MIN })
        }
    }
}

impl StrutLaw {
    /// Returns the law without force in the reference state, if it is a spring.
    pub(crate) fn unstressed(self) -> Self {
        match self {
            Self::Linear(law) => Self::Linear(LinearStrut { preload_length: 0.0, ..law }),
            Self::General(_) => self,
        }
    }

    /// Returns the law without compression, if it is a spring.
    pub(crate) fn tension_only(self) -> Self {
        match self {
            Self::Linear(law) => Self::Linear(LinearStrut { rope: true, ..law }),
            Self::General(_) => self,
        }
    }

    /// Returns N and its derivatives, which are 0 for a slack rope.
    pub(crate) fn at(&self, t: f64, change: f64, rate: f64, load: f64) -> LawValue {
        match self {
            Self::Linear(law) => law.at(change, rate, load),
            Self::General(law) => law.at(t, change, rate, load),
        }
    }

    /// Returns N of a step for zero rate.
    pub(crate) fn of_step(&self, ends: [f64; 2], step: &LocalStep<'_>) -> f64 {
        match self {
            Self::Linear(law) => law.of_step(ends, step),
            Self::General(law) => law.of_step(ends, step),
        }
    }

    /// Returns the derivatives of N for the tangent of a step, or `None` for a rope that is slack in the step.
    pub(crate) fn slopes_of_step(&self, force: f64, middle: impl FnOnce() -> LawValue) -> Option<LawValue> {
        match self {
            Self::Linear(law) if law.rope && force == 0.0 => None,
            Self::Linear(law) => Some(LawValue { force, by_position: law.stiffness, by_rate: law.damping }),
            Self::General(_) => Some(middle()),
        }
    }

    /// Returns the derivative of N by the load factor, or `None` for a slack rope.
    pub(crate) fn by_load(&self, t: f64, change: f64, load: f64) -> Option<f64> {
        match self {
            Self::Linear(law) if law.rope && law.stretch(change, load) <= 0.0 => None,
            Self::Linear(law) => Some(-law.stiffness * law.preload_length),
            Self::General(law) => Some(law.reference(t)),
        }
    }

    /// Returns the energy relative to the reference state.
    pub(crate) fn potential(&self, t: f64, change: f64, load: f64) -> f64 {
        match self {
            Self::Linear(law) => {
                let [now, first] = [change, 0.0].map(|change| law.stretch(change, load));
                0.5 * law.stiffness * (now - first) * (now + first)
            }
            Self::General(law) => law.potential(t, change, load),
        }
    }

    /// True if the force at zero rate has a potential.
    pub(crate) fn is_autonomous(&self) -> bool {
        match self {
            Self::Linear(_) => true,
            Self::General(law) => law.is_autonomous(),
        }
    }

    /// True if the force can have kinks.
    pub(crate) const fn has_kinks(&self) -> bool {
        match self {
            Self::Linear(law) => law.rope,
            Self::General(_) => true,
        }
    }

    /// True if the force can depend on the rate.
    pub(crate) fn is_damped(&self) -> bool {
        match self {
            Self::Linear(law) => law.damping > 0.0,
            Self::General(_) => true,
        }
    }

    /// Returns a bound of the rounding error of N, for those of the change of length and of its rate.
    pub(crate) fn rounding(&self, t: f64, [change, rate]: [f64; 2], errors: [f64; 2], load: f64) -> f64 {
        match self {
            Self::Linear(law) => {
                let LawValue { by_position, by_rate, .. } = law.at(change, rate, load);
                let of_change = 2.0 * f64::EPSILON * (change.abs() + (load * law.preload_length).abs());
                by_position * (errors[0] + of_change) + by_rate * errors[1]
            }
            Self::General(law) => law.rounding(t, [change, rate], errors, load),
        }
    }
}
