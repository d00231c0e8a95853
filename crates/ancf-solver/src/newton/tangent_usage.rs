use serde::{Deserialize, Serialize};

use crate::equations::Weights;
use crate::factor::FactorHistory;

/// Usage of a tangent so far.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct TangentUsage {
    pub(super) policy: TangentPolicy,
    /// Weights of the tangent, or `None` if it is not reusable.
    pub(super) weights: Option<Weights>,
    /// Age of the tangent.
    pub(super) age: TangentAge,
    /// True if an iteration of the current solution used an old tangent.
    pub(super) reused: bool,
    /// Rate θ of the last two iterations with the same tangent.
    pub(super) rate: Option<f64>,
    /// Number of solutions since the tangent was computed, now and at the last measurement of the rate.
    pub(super) solutions: u32,
    pub(super) rated: u32,
    /// Fewest iterations of a solution with this tangent, and the sum of the iterations in excess of it.
    pub(super) fewest_iterations: u32,
    pub(super) extra_iterations: u32,
    /// Number of next solutions that start with a new tangent, and the length of the last such pause.
    pub(super) pause: u32,
    pub(super) last_pause: u32,
    /// History of the factors until the last accepted step, if they are reusable.
    pub(super) factor: FactorHistory,
}

/// Policy for new tangents.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) enum TangentPolicy {
    /// A new tangent in each iteration.
    Always,
    /// A new tangent when the old one no longer pays off.
    WhenDue,
    /// A new tangent in each iteration of the current solution, then `WhenDue`.
    AlwaysInSolution,
}

/// Age of a tangent: computed for this iteration, for this solution or before.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) enum TangentAge {
    Iteration,
    Solution,
    Old,
}

impl TangentUsage {
    pub(super) const fn new() -> Self {
        Self {
            policy: TangentPolicy::Always,
            weights: None,
            age: TangentAge::Iteration,
            reused: false,
            rate: None,
            solutions: 0,
            rated: 0,
            fewest_iterations: u32::MAX,
            extra_iterations: 0,
            pause: 0,
            last_pause: 0,
            factor: FactorHistory::NEW,
        }
    }
}
