//! Model files to be measured: structures of many bodies, large models, cables in contact.

mod contact_models;
mod large_models;
mod structures;

pub use contact_models::{crossing, pile, plane};
pub use large_models::{chain, frames, modes, plate, probes};
pub use structures::{lattice, net, platform};
