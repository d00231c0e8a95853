//! Prescribed strains of beams and cables: shrinking, heating, growing, pretension.

mod beam;
mod cable;
mod list;
mod source;
mod term;

pub(crate) use beam::section_prestrains;
pub(crate) use list::Prestrains;
pub use source::Prestrain;
pub(crate) use source::{Change, ElementPlace};
pub(crate) use term::{PrestrainTerm, Prestrained};
