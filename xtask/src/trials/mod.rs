//! Trials of a program from its package: commands as a user types them, on this system and on emulated ones.

mod comparison;
mod files;
mod first_steps;
mod interruption;
mod list;
mod output;
mod program;
mod results;
mod trial;
mod view;
pub(crate) mod wine;

pub(crate) use list::run;
pub(crate) use program::Program;
