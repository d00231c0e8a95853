use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::equilibrium::{Statics, Unstable};
use super::solver_settings::Stop;
use crate::units::Scaled;

/// State at the start of the analysis. Statics and modes about an equilibrium may start from a results folder; dynamics from any
/// state.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(default, deny_unknown_fields)]
pub struct Initial {
    /// Origin of the state. The initial velocities of the bodies are added to it.
    pub from: Origin,
    /// Time of a state in the results folder, time; the last one by default.
    #[unit(time)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time: Option<f64>,
    /// Time t at the start of a motion from a results folder, time; 0 by default.
    #[unit(time)]
    #[serde(skip_serializing_if = "is_zero")]
    #[schemars(extend("minimum" = 0))]
    pub start_time: f64,
    /// Search for the equilibrium.
    pub statics: InitialStatics,
}

fn is_zero(time: &f64) -> bool {
    *time == 0.0
}

impl Initial {
    /// True if all keys have their defaults.
    pub fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

/// Origin of the state at the start of dynamics.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(rename_all = "snake_case")]
pub enum Origin {
    /// Undeformed state, or the state with closed gaps.
    #[default]
    Undeformed,
    /// Equilibrium under all loads and drives with their values at t = 0.
    Equilibrium,
    /// Results folder of another run of the same structure: its last state, or the state at `time`. Statics and modes release it to
    /// the equilibrium: forces that would hold it decrease to zero with the load factor.
    #[serde(untagged)]
    Folder(String),
}

/// Settings of the search for the equilibrium at the start. The load factor increases from 0 to 1.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(default, deny_unknown_fields)]
pub struct InitialStatics {
    /// First increment of the load factor.
    #[unit(number)]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1))]
    pub first: f64,
    /// Largest increment of the load factor.
    #[unit(number)]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1))]
    pub largest: f64,
    /// Continuation after a loss of stability.
    pub unstable: Unstable,
    /// Convergence criterion of the Newton iteration. Residual forces would set the system in motion.
    pub stop: Stop,
    /// Maximum number of Newton iterations of an increment.
    #[schemars(range(min = 1))]
    pub max_iterations: u32,
}

impl InitialStatics {
    /// Default tolerance: the residual forces at the start are close to rounding.
    const TOLERANCE: f64 = 1e-12;

    /// Settings of statics up to the full load.
    pub(crate) const fn settings(&self) -> Statics {
        let Self { first, largest, unstable, stop, max_iterations } = *self;
        Statics { load: 1.0, first, largest, unstable, stop, max_iterations }
    }
}

impl Default for InitialStatics {
    fn default() -> Self {
        let Statics { first, largest, unstable, max_iterations, .. } = Statics::default();
        Self { first, largest, unstable, stop: Stop::Energy { tolerance: Self::TOLERANCE }, max_iterations }
    }
}
