//! Model files to be measured: structures of many bodies, large and small models, cables in contact.

mod contact_models;
mod large_models;
mod small_models;
mod structures;

pub use contact_models::{crossing, pile, plane};
pub use large_models::{chain, frames, hook, modes, plate, probes, slack_cable};
pub use small_models::{arm, swing};
pub use structures::{lattice, net, platform};
