use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::solver_settings::Stop;

/// Settings of an equilibrium under growing loads: all of them, gravity among them, act `load` times.
///
/// Increments are chosen by themselves: all at once first, halves of what fails, twice what went well.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Statics {
    /// The load factor to reach.
    pub load: f64,
    /// The part of the way that is tried first.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1))]
    pub first: f64,
    /// When the Newton iteration of an increment ends.
    pub stop: Stop,
    /// Newton iterations after which an increment has failed.
    #[schemars(range(min = 1))]
    pub max_iterations: u32,
}

impl Default for Statics {
    fn default() -> Self {
        Self { load: 1.0, first: 1.0, stop: Stop::default(), max_iterations: 100 }
    }
}

/// Settings of a path of equilibria by arc length, through limit points, snap-through and snap-back.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Path {
    /// The load factor at which the path ends, when it first gets there.
    pub load: f64,
    /// The most points.
    #[schemars(range(min = 1, max = 1_000_000))]
    pub points: u32,
    /// The first step, as a change of the load factor.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub first: f64,
    /// The largest step of arc length; one that begins the path changes the load factor by as much.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub largest: f64,
    /// When the Newton iteration of a point ends.
    pub stop: Stop,
    /// Newton iterations after which a step has failed.
    #[schemars(range(min = 1))]
    pub max_iterations: u32,
}

impl Default for Path {
    fn default() -> Self {
        Self { load: 1.0, points: 1000, first: 0.05, largest: 0.2, stop: Stop::default(), max_iterations: 30 }
    }
}

/// The state about which modes and critical loads are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum About {
    /// The undeformed state, free of loads and stress.
    #[default]
    Reference,
    /// The equilibrium under all loads.
    Equilibrium,
}

/// Settings of natural frequencies and mode shapes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Modes {
    /// How many of the lowest, rigid ones included.
    #[schemars(range(min = 1, max = 10_000))]
    pub count: u32,
    /// About which state.
    pub about: About,
}

impl Default for Modes {
    fn default() -> Self {
        Self { count: 10, about: About::Reference }
    }
}

/// Settings of linear buckling: load factors at which the stiffness vanishes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Buckling {
    /// How many of the lowest.
    #[schemars(range(min = 1, max = 10_000))]
    pub count: u32,
    /// Which way the loads grow.
    pub sense: Sense,
}

impl Default for Buckling {
    fn default() -> Self {
        Self { count: 1, sense: Sense::Stated }
    }
}

/// Which way the loads grow.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Sense {
    /// As they are stated.
    #[default]
    Stated,
    /// Reversed.
    Reversed,
    /// Either way.
    Either,
}

impl From<Sense> for ancf_solver::eigen::Sense {
    fn from(sense: Sense) -> Self {
        match sense {
            Sense::Stated => Self::Stated,
            Sense::Reversed => Self::Reversed,
            Sense::Either => Self::Either,
        }
    }
}
