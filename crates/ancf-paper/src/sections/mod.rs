//! Sections of the HTML page of the paper.

mod cantilever;
mod conditioning;
mod context;
mod gain;
mod iterations;
mod markup;
mod page;
mod pendulums;
mod recovered;
mod sources;
mod summary;

pub use page::page;
