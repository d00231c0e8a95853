use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::equilibrium::{Buckling, Modes, Path, Statics};
use super::solver_settings::{NewtonMethod, Stop};

/// What to compute.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Analysis {
    /// Motion from rest in the undeformed state.
    Dynamics(Dynamics),
    /// Equilibrium under growing loads.
    Statics(Statics),
    /// A path of equilibria by arc length.
    Path(Path),
    /// Natural frequencies and mode shapes.
    Modes(Modes),
    /// Critical load factors.
    Buckling(Buckling),
}

impl Analysis {
    /// The settings, if it is one of motion.
    pub const fn dynamics(&self) -> Option<&Dynamics> {
        if let Self::Dynamics(dynamics) = self { Some(dynamics) } else { None }
    }

    /// The settings to be changed, if it is one of motion.
    pub const fn dynamics_mut(&mut self) -> Option<&mut Dynamics> {
        if let Self::Dynamics(dynamics) = self { Some(dynamics) } else { None }
    }
}

/// Settings of a dynamic analysis by a scheme of the generalized-α family on the index-3 equations.
///
/// Source: Kim et al. (2017), appendix; Arnold & Brüls (2007).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Dynamics {
    /// Duration, time.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub duration: f64,
    /// Step, time; always the user's, whatever the scales.
    pub step: Step,
    /// Scheme of time integration.
    #[serde(default)]
    pub scheme: Scheme,
    /// Accelerations and multipliers at the start.
    #[serde(default)]
    pub start: Start,
    /// When the Newton iteration of a step ends.
    #[serde(default)]
    pub stop: Stop,
    /// Newton's method with a new tangent in each iteration, or with tangents that are used again.
    #[serde(default)]
    pub newton: NewtonMethod,
    /// Newton iterations after which a step has failed.
    #[serde(default = "Dynamics::max_iterations")]
    #[schemars(range(min = 1))]
    pub max_iterations: u32,
    /// How often a failed step of fixed size may be halved before the run ends.
    #[serde(default = "Dynamics::max_halvings")]
    #[schemars(range(max = 30))]
    pub max_halvings: u32,
}

impl Dynamics {
    const fn max_iterations() -> u32 {
        50
    }

    const fn max_halvings() -> u32 {
        10
    }

    /// Settings for a duration and a step, all else by default.
    pub const fn new(duration: f64, step: f64) -> Self {
        Self {
            duration,
            step: Step::Fixed(step),
            scheme: Scheme::Adams,
            start: Start::Consistent,
            stop: Stop::Energy { tolerance: Stop::ENERGY },
            newton: NewtonMethod::Modified,
            max_iterations: Self::max_iterations(),
            max_halvings: Self::max_halvings(),
        }
    }
}

/// Steps of one size, or as large as a tolerance permits.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Step {
    /// Of this size, time; the last one ends with the duration and may be shorter.
    Fixed(#[schemars(extend("exclusiveMinimum" = 0))] f64),
    /// By error control; wants a scheme of second order.
    #[schemars(extend("additionalProperties" = false))]
    Adaptive {
        /// Error that the motion may gather over the duration, a root mean square displacement relative to the length of the
        /// longest body.
        #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 0.1))]
        tolerance: f64,
        /// First step, time; found by itself if left out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        initial: Option<f64>,
        /// Largest step, time.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        largest: Option<f64>,
    },
}

impl Step {
    /// The size, if it is fixed.
    pub const fn fixed(&self) -> Option<f64> {
        match *self {
            Self::Fixed(step) => Some(step),
            Self::Adaptive { .. } => None,
        }
    }
}

/// A scheme of time integration, by name or by number.
///
/// Source: Kim et al. (2017), table of the appendix; Hilber, Hughes & Taylor (1977); Chung & Hulbert (1993).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Scheme {
    /// Newmark with γ = 0.70, β = 0.36: first order, strongly damping; the choice of the paper.
    #[default]
    Adams,
    /// Newmark with γ = 1/2, β = 1/4: second order, keeps the energy of linear systems; with joints, reactions alternate.
    AverageAcceleration,
    /// Newmark with γ = 1/2, β = 1/6: second order, stable for small steps only; refused with joints, where it never is.
    LinearAcceleration,
    /// Newmark with γ = 1/2, β = 0: explicit, hence refused for equations with constraints.
    CentralDifference,
    /// Newmark with any pair.
    #[serde(untagged)]
    #[schemars(extend("additionalProperties" = false))]
    Pair {
        /// γ; 1/2 for second order, more for damping.
        #[schemars(range(min = 0, max = 1))]
        gamma: f64,
        /// β > 0.
        #[schemars(range(min = 0, max = 1))]
        beta: f64,
    },
    /// Generalized-α: second order, in reactions too, damps what the step does not resolve.
    #[serde(untagged)]
    #[schemars(extend("additionalProperties" = false))]
    GeneralizedAlpha {
        /// Part of a vibration of infinite frequency that survives a step: 0 ends it, 1 damps nothing, 0.8 is a good choice.
        #[schemars(range(min = 0, max = 1))]
        spectral_radius: f64,
    },
    /// The scheme of Hilber, Hughes and Taylor: second order, in reactions too, damps high frequencies.
    #[serde(untagged)]
    #[schemars(extend("additionalProperties" = false))]
    Hht {
        /// From −1/3, most damping, to 0, none.
        #[schemars(extend("minimum" = -1.0 / 3.0, "maximum" = 0))]
        alpha: f64,
    },
}

impl Scheme {
    /// Its four numbers.
    pub const fn numbers(&self) -> ancf_solver::dynamics::Scheme {
        use ancf_solver::dynamics::Scheme;
        match *self {
            Self::Adams => Scheme::ADAMS,
            Self::AverageAcceleration => Scheme::AVERAGE_ACCELERATION,
            Self::LinearAcceleration => Scheme::LINEAR_ACCELERATION,
            Self::CentralDifference => Scheme::newmark(0.5, 0.0),
            Self::Pair { gamma, beta } => Scheme::newmark(gamma, beta),
            Self::GeneralizedAlpha { spectral_radius } => Scheme::generalized_alpha(spectral_radius),
            Self::Hht { alpha } => Scheme::hht(alpha),
        }
    }
}

/// Accelerations and multipliers at the start.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Start {
    /// Those that satisfy the equations of motion.
    #[default]
    Consistent,
    /// All zero, as Kim et al. (2017) have it.
    Zero,
}
