//! Rigid bodies: tops, pendulums, small oscillations.

mod oscillations;
mod tops;

use crate::Problem;

/// Problems of rigid bodies.
pub(super) const FAMILIES: [&[Problem]; 2] = [tops::PROBLEMS, oscillations::PROBLEMS];
