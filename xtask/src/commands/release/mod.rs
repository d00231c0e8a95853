//! Commands that build and try packages.

pub(crate) mod container;
pub(crate) mod dry_run;
pub(crate) mod platforms;
