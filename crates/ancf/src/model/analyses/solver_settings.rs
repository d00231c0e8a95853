use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Scaled;

/// Update of the tangent in Newton's method.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(rename_all = "snake_case")]
pub enum NewtonMethod {
    /// Modified Newton: a new tangent only if it costs less than more iterations with the old tangent. Absolute convergence
    /// criteria and redundant joints require the full method.
    #[default]
    Modified,
    /// Full Newton: a new tangent in each iteration.
    Full,
}

/// Convergence criterion of a Newton iteration.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(tag = "rule", rename_all = "snake_case", deny_unknown_fields)]
pub enum Stop {
    /// Energy criterion, independent of units. The energy |Δz·r| of the increment is at most tolerance² times the largest
    /// energy of the run, or the residual reaches its rounding error.
    Energy {
        /// Relative magnitude of the increment in the energy norm.
        #[unit(number)]
        #[serde(default = "Stop::energy")]
        #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 0.01))]
        tolerance: f64,
    },
    /// Residual |r|₂ below an absolute number *in the units of the solver*.
    Residual {
        /// Upper bound of the Euclidean norm of the residual.
        #[unit(none)]
        #[schemars(extend("exclusiveMinimum" = 0))]
        tolerance: f64,
    },
    /// Increment |Δq|₂ below an absolute number *in the units of the solver*.
    Increment {
        /// Upper bound of the Euclidean norm of the increment of the coordinates.
        #[unit(none)]
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

impl From<Stop> for ancf_solver::newton::StopRule {
    fn from(stop: Stop) -> Self {
        match stop {
            Stop::Energy { tolerance } => Self::Energy(tolerance),
            Stop::Residual { tolerance } => Self::Residual(tolerance),
            Stop::Increment { tolerance } => Self::Increment(tolerance),
        }
    }
}

/// Limits of the error of the energy balance in dynamics.
///
/// The error is relative to the exchanged energy: the largest sum of kinetic and strain energy, plus the magnitudes of the work and
/// of the dissipation of all steps.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct EnergyGuard {
    /// Largest energy that the integration may make, relative to the exchanged energy. Steps above it are halved, finally rejected.
    #[unit(number)]
    #[serde(default = "EnergyGuard::gain")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub gain: f64,
    /// Largest energy that the integration may lose without a warning, by the numerical damping of the scheme.
    #[unit(number)]
    #[serde(default = "EnergyGuard::loss")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub loss: f64,
}

impl EnergyGuard {
    pub(crate) const DEFAULT: Self = Self { gain: Self::gain(), loss: Self::loss() };

    const fn gain() -> f64 {
        0.05
    }

    const fn loss() -> f64 {
        0.05
    }
}

impl Default for EnergyGuard {
    fn default() -> Self {
        Self::DEFAULT
    }
}
