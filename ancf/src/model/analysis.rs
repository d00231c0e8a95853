use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What to compute.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Analysis {
    /// Motion from rest in the undeformed state.
    Dynamics(Dynamics),
}

/// Settings of a dynamic analysis by Newmark's scheme on the index-3 equations.
///
/// Source: Kim et al. (2017), appendix.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Dynamics {
    /// Duration, time.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub duration: f64,
    /// Step, time; always the user's, whatever the scales.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub step: f64,
    /// Scheme of time integration.
    #[serde(default)]
    pub scheme: Newmark,
    /// Accelerations and multipliers at the start.
    #[serde(default)]
    pub start: Start,
    /// When the Newton iteration of a step ends.
    #[serde(default)]
    pub stop: Stop,
    /// Newton iterations after which a step has failed.
    #[serde(default = "Dynamics::max_iterations")]
    #[schemars(range(min = 1))]
    pub max_iterations: u32,
    /// How often a failed step may be halved before the run ends.
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
            step,
            scheme: Newmark::Adams,
            start: Start::Consistent,
            stop: Stop::Energy { tolerance: Stop::ENERGY },
            max_iterations: Self::max_iterations(),
            max_halvings: Self::max_halvings(),
        }
    }
}

/// A pair (γ, β) of Newmark's scheme, by name or by number.
///
/// Source: Kim et al. (2017), table of the appendix.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Newmark {
    /// γ = 0.70, β = 0.36: first order, strongly damping; the choice of the paper.
    #[default]
    Adams,
    /// γ = 1/2, β = 1/4: second order, keeps the energy of linear systems.
    AverageAcceleration,
    /// γ = 1/2, β = 1/6: second order, stable for small steps only; with joints it is not stable at all.
    LinearAcceleration,
    /// γ = 1/2, β = 0: explicit, hence refused for equations with constraints.
    CentralDifference,
    /// Any pair.
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
}

impl Newmark {
    /// The numbers (γ, β).
    pub const fn pair(&self) -> (f64, f64) {
        match *self {
            Self::Adams => (0.70, 0.36),
            Self::AverageAcceleration => (0.5, 0.25),
            Self::LinearAcceleration => (0.5, 1.0 / 6.0),
            Self::CentralDifference => (0.5, 0.0),
            Self::Pair { gamma, beta } => (gamma, beta),
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

/// When a Newton iteration ends.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "rule", rename_all = "snake_case", deny_unknown_fields)]
pub enum Stop {
    /// Unit-blind: the energy |Δz·r| of the increment is at most tolerance² times the largest energy met, or the
    /// residual is down to its own rounding error.
    Energy {
        /// Relative size of the increment in the energy norm.
        #[serde(default = "Stop::energy")]
        #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 0.01))]
        tolerance: f64,
    },
    /// |r|₂ below an absolute number *in the units of the solver*, hence unit-dependent.
    Residual {
        /// Bound on the Euclidean norm of the residual.
        #[schemars(extend("exclusiveMinimum" = 0))]
        tolerance: f64,
    },
    /// |Δq|₂ below an absolute number *in the units of the solver*, hence unit-dependent.
    Increment {
        /// Bound on the Euclidean norm of the increment of the coordinates.
        #[schemars(extend("exclusiveMinimum" = 0))]
        tolerance: f64,
    },
}

impl Stop {
    const ENERGY: f64 = 1e-8;

    const fn energy() -> f64 {
        Self::ENERGY
    }
}

impl Default for Stop {
    fn default() -> Self {
        Self::Energy { tolerance: Self::ENERGY }
    }
}
