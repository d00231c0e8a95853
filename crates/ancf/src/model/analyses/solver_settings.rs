use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// When Newton's method makes a new tangent.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum NewtonMethod {
    /// When it is cheaper than more iterations with an old one; the same solutions in less time. Rules in absolute
    /// numbers for the end of the iteration, and redundant joints, want the full method and get it.
    #[default]
    Modified,
    /// In each iteration.
    Full,
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
    pub(crate) const ENERGY: f64 = 1e-8;

    const fn energy() -> f64 {
        Self::ENERGY
    }
}

impl Default for Stop {
    fn default() -> Self {
        Self::Energy { tolerance: Self::ENERGY }
    }
}

impl From<Stop> for ancf_solver::newton::Stop {
    fn from(stop: Stop) -> Self {
        match stop {
            Stop::Energy { tolerance } => Self::Energy(tolerance),
            Stop::Residual { tolerance } => Self::Residual(tolerance),
            Stop::Increment { tolerance } => Self::Increment(tolerance),
        }
    }
}
