//! Checks of a model beyond its schema.

mod bodies;
mod capabilities;
mod contacts;
mod display;
mod findings;
mod friction;
mod joints;
mod loads;
mod memory;
mod rules;
mod scheme;
mod shells;
mod time_functions;

pub(crate) use memory::{available, factor_storage, memory_of_equations, with_memory};
pub(crate) use rules::broken_rules;
