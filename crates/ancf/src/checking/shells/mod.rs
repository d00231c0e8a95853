//! Checks of shells.

mod laminates;
mod rules;

pub(super) use rules::shells;
