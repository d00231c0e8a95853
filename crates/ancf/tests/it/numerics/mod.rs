//! Linear algebra and rounding.

mod chain_cost;
mod factorisation;
mod rounding_floor;
