use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::end_condition::EndCondition;
use super::equilibrium::{Buckling, Modes, Path, Statics};
use super::solver_settings::{EnergyGuard, NewtonMethod, Stop};
use crate::units::Scaled;

/// Analysis to run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Analysis {
    /// Motion that starts in the undeformed state.
    Dynamics(Dynamics),
    /// Equilibrium under increasing loads.
    Statics(Statics),
    /// Equilibrium path by arc length continuation.
    Path(Path),
    /// Natural frequencies and mode shapes.
    Modes(Modes),
    /// Critical load factors.
    Buckling(Buckling),
}

impl Analysis {
    /// Settings of a dynamic analysis.
    pub const fn dynamics(&self) -> Option<&Dynamics> {
        if let Self::Dynamics(dynamics) = self { Some(dynamics) } else { None }
    }

    /// True if the velocities of the states are shapes of modes or critical loads.
    pub const fn has_shapes(&self) -> bool {
        matches!(self, Self::Modes(_) | Self::Buckling(_))
    }

    /// Mutable settings of a dynamic analysis.
    pub const fn dynamics_mut(&mut self) -> Option<&mut Dynamics> {
        if let Self::Dynamics(dynamics) = self { Some(dynamics) } else { None }
    }
}

/// Settings of a dynamic analysis by a scheme of the generalized-α family on the index-3 equations.
///
/// Source: Kim et al. (2017), appendix; Arnold & Brüls (2007).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Dynamics {
    /// Duration, time.
    #[unit(time)]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub duration: f64,
    /// Step size, time; in the units of the model with any `scales`.
    pub step: Step,
    /// Time integration scheme.
    #[serde(default)]
    pub scheme: Scheme,
    /// Accelerations and multipliers at the start.
    #[serde(default)]
    pub start: Start,
    /// Convergence criterion of the Newton iteration.
    #[serde(default)]
    pub stop: Stop,
    /// Newton's method with reused tangents, or with a new tangent in each iteration.
    #[serde(default)]
    pub newton: NewtonMethod,
    /// Maximum number of Newton iterations of a step.
    #[serde(default = "Dynamics::max_iterations")]
    #[schemars(range(min = 1))]
    pub max_iterations: u32,
    /// Maximum number of successive halvings of a failed step of fixed size.
    #[serde(default = "Dynamics::max_halvings")]
    #[schemars(range(max = 30))]
    pub max_halvings: u32,
    /// Limits of the error of the energy balance.
    #[serde(default)]
    pub energy_guard: EnergyGuard,
    /// Conditions that end the motion before its duration, such as a force above a limit; the first one that is met ends it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub until: Vec<EndCondition>,
}

impl Dynamics {
    /// Remainder of a duration, relative to the step, below which the last step is longer instead of a further step that is much
    /// shorter. Accelerations have rounding errors of ε x/h² in a step h.
    pub(crate) const SMALL_REMAINDER: f64 = 0.01;

    /// Size of fixed steps between output times with an interval, which they divide. `None` for error control.
    pub(crate) fn nominal_step(&self, interval: Option<f64>) -> Option<f64> {
        let step = self.step.fixed()?;
        let parts = |interval: f64| (interval / step - Self::SMALL_REMAINDER).ceil().max(1.0);
        Some(interval.map_or(step, |interval| interval / parts(interval)))
    }

    const fn max_iterations() -> u32 {
        50
    }

    const fn max_halvings() -> u32 {
        10
    }

    /// Settings with a duration and a fixed step; default values otherwise.
    pub const fn new(duration: f64, step: f64) -> Self {
        Self {
            duration,
            step: Step::Fixed(step),
            scheme: Scheme::DEFAULT,
            start: Start::Consistent,
            stop: Stop::Energy { tolerance: Stop::ENERGY },
            newton: NewtonMethod::Modified,
            max_iterations: Self::max_iterations(),
            max_halvings: Self::max_halvings(),
            energy_guard: EnergyGuard::DEFAULT,
            until: Vec::new(),
        }
    }
}

/// Fixed or adaptive step size.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(untagged)]
pub enum Step {
    /// Fixed step size, time. The last step ends with the duration and may be shorter.
    Fixed(
        #[unit(time)]
        #[schemars(extend("exclusiveMinimum" = 0))]
        f64,
    ),
    /// Step size by error control; requires a scheme of second order.
    #[schemars(extend("additionalProperties" = false))]
    Adaptive {
        /// Error tolerance of the motion over the duration: root mean square displacement relative to the length of the
        /// longest flexible body, or to the extent of a model without flexible bodies.
        #[unit(number)]
        #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 0.1))]
        tolerance: f64,
        /// First step, time; estimated by default.
        #[unit(time)]
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        initial: Option<f64>,
        /// Largest step, time; not limited by default.
        #[unit(time)]
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        largest: Option<f64>,
    },
}

impl Step {
    /// Step size, if it is fixed.
    pub const fn fixed(&self) -> Option<f64> {
        match *self {
            Self::Fixed(step) => Some(step),
            Self::Adaptive { .. } => None,
        }
    }

    /// Fixed step size, or a size of the order of adaptive steps.
    pub(crate) fn typical(&self, duration: f64) -> f64 {
        match *self {
            Self::Fixed(step) => step,
            Self::Adaptive { initial, largest, .. } => {
                initial.unwrap_or(Self::TYPICAL * duration).min(largest.unwrap_or(duration))
            }
        }
    }

    /// Order of adaptive steps, relative to the duration.
    const TYPICAL: f64 = 1e-3;
}

/// Time integration scheme, by name or by parameters.
///
/// Source: Kim et al. (2017), table of the appendix; Hilber, Hughes & Taylor (1977); Chung & Hulbert (1993).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(rename_all = "snake_case")]
pub enum Scheme {
    /// Newmark with γ = 0.70, β = 0.36: first order, strong numerical damping. Used by Kim et al. (2017).
    Adams,
    /// Newmark with γ = 1/2, β = 1/4: second order, conserves the energy of linear systems. Joint reactions oscillate.
    AverageAcceleration,
    /// Newmark with γ = 1/2, β = 1/6: second order, conditionally stable. Rejected with joints, where it is unstable.
    LinearAcceleration,
    /// Newmark with γ = 1/2, β = 0: explicit. Rejected for equations with constraints.
    CentralDifference,
    /// Energy-momentum scheme: second order, conserves energy and momentum exactly in steps of any size. No numerical damping.
    Energy,
    /// Newmark with given parameters.
    #[serde(untagged)]
    #[schemars(extend("additionalProperties" = false))]
    Pair {
        /// γ; 1/2 for second order, larger for numerical damping.
        #[unit(number)]
        #[schemars(range(min = 0, max = 1))]
        gamma: f64,
        /// β > 0.
        #[unit(number)]
        #[schemars(range(min = 0, max = 1))]
        beta: f64,
    },
    /// Generalized-α: second order, also in reactions. Damps frequencies that the step does not resolve.
    #[serde(untagged)]
    #[schemars(extend("additionalProperties" = false))]
    GeneralizedAlpha {
        /// Spectral radius ρ at infinite frequency, from 0 (maximum damping) to 1 (no damping). Rotations of ω h radians per step
        /// are stable up to 0.7 (1 − ρ).
        #[unit(number)]
        #[schemars(range(min = 0, max = 1))]
        spectral_radius: f64,
    },
    /// Scheme of Hilber, Hughes and Taylor: second order, also in reactions. Damps high frequencies.
    #[serde(untagged)]
    #[schemars(extend("additionalProperties" = false))]
    Hht {
        /// α from −1/3 (maximum damping) to 0 (no damping).
        #[unit(number)]
        #[schemars(extend("minimum" = -1.0 / 3.0, "maximum" = 0))]
        alpha: f64,
    },
    /// Energy-momentum scheme with numerical damping of the strains of beams, cables and springs.
    #[serde(untagged)]
    #[schemars(extend("additionalProperties" = false))]
    DampedEnergy {
        /// χ ≥ 0: strains have the weights ½ − χ at the start and ½ + χ at the end of a step. Resolved vibrations lose little for χ
        /// far below 0.05.
        #[unit(number)]
        #[schemars(range(min = 0, max = 0.5))]
        energy_damping: f64,
    },
}

impl Default for Scheme {
    fn default() -> Self {
        Self::DEFAULT
    }
}

impl Scheme {
    /// Generalized-α with ρ = 0.6. A vibration of 100 steps a period loses 0.1 % of its energy in 50 periods, and rotations of at
    /// least 22 steps a turn are stable. With ρ = 0.8 they lose a tenth of this and require 45 steps a turn.
    pub const DEFAULT: Self = Self::GeneralizedAlpha { spectral_radius: 0.6 };

    /// Parameters of the scheme.
    pub const fn numbers(&self) -> ancf_solver::dynamics::SchemeCoefficients {
        use ancf_solver::dynamics::SchemeCoefficients;
        match *self {
            Self::Adams => SchemeCoefficients::ADAMS,
            Self::AverageAcceleration => SchemeCoefficients::AVERAGE_ACCELERATION,
            Self::LinearAcceleration => SchemeCoefficients::LINEAR_ACCELERATION,
            Self::CentralDifference => SchemeCoefficients::newmark(0.5, 0.0),
            Self::Pair { gamma, beta } => SchemeCoefficients::newmark(gamma, beta),
            Self::GeneralizedAlpha { spectral_radius } => {
                SchemeCoefficients::generalized_alpha(spectral_radius)
            }
            Self::Hht { alpha } => SchemeCoefficients::hht(alpha),
            Self::Energy => SchemeCoefficients::energy_momentum(0.0),
            Self::DampedEnergy { energy_damping } => SchemeCoefficients::energy_momentum(energy_damping),
        }
    }
}

/// Accelerations and multipliers at the start.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(rename_all = "snake_case")]
pub enum Start {
    /// Initial values that satisfy the equations of motion.
    #[default]
    Consistent,
    /// Zero, as in Kim et al. (2017).
    Zero,
}
