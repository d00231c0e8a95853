//! Rules that a valid model satisfies beyond its schema.

mod bodies;
mod capabilities;
mod contacts;
mod joints;
mod loads;
mod rules;
mod scheme;
mod time_functions;

pub(crate) use rules::{ON_AXIS, broken_rules, joints_of, with_memory};
pub(crate) use time_functions::loads_of;
