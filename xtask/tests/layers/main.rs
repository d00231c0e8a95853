//! The command `cargo xtask layers` on small workspaces.
#![cfg(test)]

mod python;
mod rules;
mod rust;
mod typescript;
mod workspace;
