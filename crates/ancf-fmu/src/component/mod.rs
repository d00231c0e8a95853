//! Instance of an FMU, independent of the version of the standard.

mod access;
mod advance;
mod fault;
mod instance;
mod resources;
mod saved;

pub(crate) use fault::{Fault, Level, guarded};
pub(crate) use instance::Instance;
pub(crate) use resources::{Resources, folder_of};
pub(crate) use saved::SavedState;
