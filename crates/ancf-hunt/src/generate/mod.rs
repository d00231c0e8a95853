//! Random models from a seed: connected, supported where the analysis requires it, with steps that resolve the motion.

mod analysis;
mod bodies;
mod contacts;
mod draft;
mod joints;
mod loads;
mod model;
mod probes;
mod shells;

pub use model::model;
