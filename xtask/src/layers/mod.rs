//! Checks the module structure of the workspace by `layers.toml`: folders in layers, imports that point downwards,
//! no cycle of files, limits on files and lines.

mod command;
mod config;
mod cycles;
mod import;
mod python;
mod rules;
mod rust;
mod source;
mod typescript;
mod violation;

pub(crate) use command::check;
