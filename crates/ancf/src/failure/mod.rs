//! Causes of failed iterations, loss of stability, and advice to the user.

mod advice;
mod cause;
mod stability;
mod stability_watch;

pub(crate) use advice::{OF_MECHANISMS, after, after_search};
pub(crate) use cause::{Blame, Place, blame};
pub(crate) use stability::unloaded;
pub(crate) use stability_watch::Watch;
