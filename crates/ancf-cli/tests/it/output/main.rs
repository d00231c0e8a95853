//! The manners of the program: starting models, help, plots, JSON, colours, messages.
#![cfg(test)]

mod bench;
mod json;
mod messages;
mod plot;
mod start;
