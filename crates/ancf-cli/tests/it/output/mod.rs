//! Output of the program: templates, help, plots, JSON, colours, messages.

mod display;
mod json;
mod messages;
mod plot;
mod start;
mod unwritable;
