//! Supports of shells.

mod condition;
mod edge_equations;
mod support;

pub use condition::{SupportCondition, SupportedAxis};
pub use support::Support;
