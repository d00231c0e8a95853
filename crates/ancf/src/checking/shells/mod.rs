//! Checks of shells.

mod fields;
mod laminates;
mod meshes;
mod rules;

pub(super) use rules::shells;
