//! Linear algebra and rounding errors.

mod chain_cost;
mod factorisation;
mod rounding_floor;
