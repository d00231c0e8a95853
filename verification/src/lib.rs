//! Problems with known answers: closed forms, independent solutions, published numbers.
//!
//! Each problem is a file of [`problems`], named by its source: model, reference, tolerance and plot in one place, with a
//! test that it holds. `ancf verify` runs them all on a user's own machine and writes a report.

mod problem;
pub mod problems;

pub use problem::{Comparison, Curve, Error, Findings, Mark, Plot, Problem, Solved, solve};
