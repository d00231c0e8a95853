//! Checks of shells.

mod rules;

pub(super) use rules::shells;
