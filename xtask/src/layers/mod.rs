//! Checks the module structure of the workspace by `layers.toml`: folders in layers, imports that point downwards,
//! no cycle of files, limits on files and lines.

mod command;
mod cycles;
mod members;
mod python;
mod rules;
mod rust;
mod typescript;
mod workspace;

pub(crate) use command::check;
