//! Flexible multibody dynamics on the absolute nodal coordinate formulation (ANCF).
//!
//! A [`Model`] states beams, joints, loads and an analysis in the user's units. [`simulate`](fn@simulate) converts it into the
//! units of its [`Scales`] and assembles the index-3 equations of motion
//!
//! M a + f(q) + Φ_qᵀ λ = 0,  Φ(q) = 0.
//!
//! They are integrated by a generalized-α scheme with Newton's method and the exact tangent. A [`Sink`](record::Sink) receives
//! the output rows in the user's units.
//!
//! | module | contents |
//! |---|---|
//! | [`model`], [`joints`], [`loads`] | data of a model; joints, loads and sections are one file per kind |
//! | [`reading`], [`schema`], [`errors`] | model files, their JSON Schema and error messages |
//! | [`units`] | units, scales and dimensions |
//! | [`assembly`] | equations of motion of a model |
//! | [`diagnosis`] | degrees of freedom, redundant constraints, free motions |
//! | [`record`] | sinks for result rows |
//! | [`mechanics`] | elements, constraints and forces |
//! | [`solver`] | time integration, statics, eigenvalues, sparse equations |
//!
//! Below are the crates [`mechanics`] (elements, constraints, forces, contact) and [`solver`] (Newton's method, integrators, sparse
//! factorisation).
//!
//! The cantilever of Kim et al. (2017), dropped under its own weight:
//!
//! ```
//! use ancf::record::Series;
//! use ancf::{Model, simulate};
//!
//! let model = Model::parse(
//!     r#"
//!     gravity = [0, -9.81, 0]
//!     materials.steel = { density = 8030, young = 193e9 }
//!     sections.rod = { kind = "circle", diameter = 0.02 }
//!
//!     [[bodies]]
//!     kind = "beam"
//!     name = "beam"
//!     from = [0, 0, 0]
//!     to = [1, 0, 0]
//!     elements = 2
//!     formulation = "continuum"
//!     section = "rod"
//!     material = "steel"
//!
//!     [[joints]]
//!     kind = "clamp"
//!     name = "root"
//!     a = { body = "beam", at = "start" }
//!
//!     [[probes]]
//!     name = "tip"
//!     on = { body = "beam", at = "end" }
//!
//!     [analysis]
//!     kind = "dynamics"
//!     duration = 2.0
//!     step = 1e-3
//!     scheme = "adams"
//!     energy_guard = { loss = 1 }
//!     start = "zero"
//!     "#,
//! )?;
//! let mut series = Series::new();
//! let summary = simulate(&model, &mut series)?;
//! assert!(summary.outcome.is_finished());
//! let tip = series.column("tip.y").ok_or("no such column")?;
//! let mean = tip.iter().sum::<f64>() / tip.len() as f64;
//! assert!((mean - -1.870e-3).abs() < 2e-6); // Kim et al. (2017), table 5, two elements
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

// `#[derive(Scaled)]` names this crate by its path.
extern crate self as ancf;

pub mod assembly;
mod checking;
pub mod diagnosis;
pub mod errors;
pub mod estimate;
mod failure;
mod gradients;
mod initial;
pub mod joints;
pub mod loads;
pub mod model;
pub mod reading;
pub mod record;
mod refine;
mod results;
mod scaling;
pub mod schema;
mod simulate;
mod stepping;
pub mod units;

pub use ancf_mechanics as mechanics;
pub use ancf_solver as solver;
pub use errors::{ModelError, ModelErrors};
pub use gradients::{GradientError, Gradients, Parameter, gradients};
pub use initial::{GivenState, InitialReport, StartState};
pub use model::Model;
pub use nalgebra;
pub use refine::{RefinedModel, RefinementHistory, can_refine, refine};
pub use results::{Column, Field, Fields, Rows, Station};
pub use simulate::{
    Checkpoint, EigenvalueCount, Error, Extension, Observer, Outcome, ResumeError, Simulation,
    SimulationBuilder, Summary, simulate,
};
pub use stepping::{
    BodyLayout, CompleteState, DescriptorForm, InputUse, LinearModel, Projection, StepError, Stepper,
};
pub use units::Scales;

/// The example of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
