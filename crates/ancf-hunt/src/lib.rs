//! Search for wrong results: random models, held to the same physics as their transformed twins.
//!
//! A model of [`generate`] is run ([`run`]). Each of the [`laws`] compares it with a twin in another frame, in other units, in
//! another order, or checks a balance. Deviations above the tolerances of [`compare`] are findings, which [`shrink`] reduces to
//! a small model.

pub mod compare;
pub mod frames;
pub mod generate;
pub mod hunt;
pub mod known;
pub mod laws;
pub mod random;
pub mod run;
pub mod shrink;
