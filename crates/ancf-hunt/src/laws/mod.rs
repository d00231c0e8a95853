//! Laws of all models: invariance under transformations, balances, convergence. One file per family, one line per law.

mod balances;
mod ends;
mod estimate;
mod frames;
mod law;
mod order;
mod refinement;
mod reversal;
mod solution;
mod split;
mod units;

pub use law::{Check, Law};

/// All laws.
pub const LAWS: [&dyn Law; 22] = [
    &balances::Finite,
    &balances::Energy,
    &balances::Reactions,
    &balances::Momentum,
    &frames::Rotation,
    &frames::QuarterTurn,
    &frames::Reflection,
    &frames::Translation,
    &units::UnitsOfModel,
    &units::UnitsOfSolver,
    &units::SlopeCoordinates,
    &order::Order,
    &ends::Exchange,
    &reversal::Reversal,
    &split::Split,
    &refinement::Steps,
    &refinement::Elements,
    &estimate::Estimate,
    &estimate::MotionErrors,
    &solution::Tangents,
    &solution::Threads,
    &solution::Resumption,
];
