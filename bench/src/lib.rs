//! Measurement of the speed of `ancf`: a table of costs with targets, and instruction counts for comparison.
//!
//! ```text
//!   table     instructions     cost per element with targets, peers and machine peak; instruction counts of fixed work
//!        \     /
//!        measure               CPU time, repeated samples, machine peak
//!           |
//!        subjects              cantilever models and the work to be measured
//!           |
//!        models                model files of large models, structures and contacts
//! ```
//!
//! Only the public interface of the library is used, so that measurements do not depend on its implementation.
//! `benches/rows.rs` measures the same subjects with criterion.

pub mod instructions;
pub mod measure;
pub mod models;
pub mod subjects;
pub mod table;

pub use subjects::Result;
