use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::solver_settings::Stop;
use crate::units::Scaled;

/// Settings of an equilibrium under increasing loads. The factor `load` multiplies all loads, gravity included.
///
/// Load increments are automatic. A failed increment is halved; after a success the next increment is doubled. An increment
/// turns drives by at most 30° and bodies by at most 120°.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(default, deny_unknown_fields)]
pub struct Statics {
    /// Final load factor.
    #[unit(number)]
    pub load: f64,
    /// First increment, as a fraction of the final load factor.
    #[unit(number)]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1))]
    pub first: f64,
    /// Largest increment, as a fraction of the final load factor.
    #[unit(number)]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1))]
    pub largest: f64,
    /// Continuation after a loss of stability.
    pub unstable: Unstable,
    /// Convergence criterion of the Newton iteration.
    pub stop: Stop,
    /// Maximum number of Newton iterations of an increment.
    #[schemars(range(min = 1))]
    pub max_iterations: u32,
}

impl Statics {
    /// Expected load factor of statics from a given state.
    pub(crate) const RELEASING: &str = "another number than 0 for statics from a given state, which is released in proportion to the load factor";
}

impl Default for Statics {
    fn default() -> Self {
        Self {
            load: 1.0,
            first: 1.0,
            largest: 1.0,
            unstable: Unstable::Follow,
            stop: Stop::default(),
            max_iterations: 100,
        }
    }
}

/// Continuation of statics after a loss of stability.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(rename_all = "snake_case")]
pub enum Unstable {
    /// Failure at the last stable equilibrium.
    Stop,
    /// Unstable equilibria, with a warning.
    #[default]
    Follow,
    /// A stable branch in an unstable direction.
    Leave,
}

impl From<Unstable> for ancf_solver::statics::UnstablePolicy {
    fn from(unstable: Unstable) -> Self {
        match unstable {
            Unstable::Stop => Self::Stop,
            Unstable::Follow => Self::Follow,
            Unstable::Leave => Self::Leave,
        }
    }
}

/// Settings of an equilibrium path by arc length continuation, through limit points, snap-through and snap-back.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(default, deny_unknown_fields)]
pub struct Path {
    /// Load factor at which the path ends when it first reaches it. For the other direction, reverse the loads.
    #[unit(number)]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub load: f64,
    /// Maximum number of points.
    #[schemars(range(min = 1, max = 1_000_000))]
    pub points: u32,
    /// First step, as a change of the load factor.
    #[unit(number)]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub first: f64,
    /// Largest step of arc length, as the change of the load factor by a step of this length at the start of the path.
    #[unit(number)]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub largest: f64,
    /// Convergence criterion of the Newton iteration.
    pub stop: Stop,
    /// Maximum number of Newton iterations of a step.
    #[schemars(range(min = 1))]
    pub max_iterations: u32,
}

impl Default for Path {
    fn default() -> Self {
        Self { load: 1.0, points: 1000, first: 0.05, largest: 0.2, stop: Stop::default(), max_iterations: 30 }
    }
}

/// State about which natural modes are computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(rename_all = "snake_case")]
pub enum About {
    /// Undeformed state, free of loads and stress.
    #[default]
    Reference,
    /// Equilibrium under all loads.
    Equilibrium,
}

/// Settings of natural frequencies and mode shapes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(default, deny_unknown_fields)]
pub struct Modes {
    /// Number of the lowest modes, rigid body modes included.
    #[schemars(range(min = 1, max = 10_000))]
    pub count: u32,
    /// State about which the equations are linearised.
    pub about: About,
    /// True for modes with damping and gyroscopic forces: frequencies, damping ratios and growth rates.
    pub damped: bool,
}

impl Default for Modes {
    fn default() -> Self {
        Self { count: 10, about: About::Reference, damped: false }
    }
}

/// Settings of linear buckling: load factors at which the stiffness becomes singular.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(default, deny_unknown_fields)]
pub struct Buckling {
    /// Number of the lowest load factors.
    #[schemars(range(min = 1, max = 10_000))]
    pub count: u32,
    /// Sign of the load factors.
    pub sense: Sense,
}

impl Default for Buckling {
    fn default() -> Self {
        Self { count: 1, sense: Sense::Stated }
    }
}

/// Sign of the load factors of buckling.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(rename_all = "snake_case")]
pub enum Sense {
    /// Positive: loads act as stated.
    #[default]
    Stated,
    /// Negative: loads are reversed.
    Reversed,
    /// Both signs.
    Either,
}

impl From<Sense> for ancf_solver::eigen::LoadDirection {
    fn from(sense: Sense) -> Self {
        match sense {
            Sense::Stated => Self::Stated,
            Sense::Reversed => Self::Reversed,
            Sense::Either => Self::Either,
        }
    }
}
