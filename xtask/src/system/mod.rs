//! Programs outside the workspace: how they are found, installed and run.

pub(crate) mod debian;
pub(crate) mod environment;
pub(crate) mod shell;
pub(crate) mod tools;
