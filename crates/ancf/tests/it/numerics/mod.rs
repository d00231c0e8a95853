//! Linear algebra and rounding errors.

mod chain_cost;
mod factorisation;
mod null_space;
mod rounding_floor;
