//! Checks of shells.

mod laminates;
mod meshes;
mod rules;

pub(super) use rules::shells;
