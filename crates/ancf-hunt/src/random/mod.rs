//! Pseudo-random numbers: SplitMix64 (Steele, Lea & Flood 2014). A seed gives the same model on every computer.

mod generator;

pub use generator::{Random, rounded};
