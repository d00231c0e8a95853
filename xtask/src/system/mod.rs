//! Programs outside the workspace: search, installation, execution.

pub(crate) mod debian;
pub(crate) mod environment;
pub(crate) mod shell;
pub(crate) mod tools;
