//! Estimates of the discretisation error of results.
//!
//! The gap between each element and the exact rod under the section forces of the element is imposed on the structure. The
//! response to all gaps is the error of the whole state, from which those of all values follow. The work of the gaps of a mode or
//! a buckling shape on this shape gives the error of its frequency or load factor.
//!
//! Models with shells have no exact rod. On request they are solved again with elements of half the size, and the differences give the
//! errors by Richardson's extrapolation.

mod body_errors;
mod discretisation_errors;
mod factor_errors;
mod finer;
mod frequency_errors;
mod gap_field;
mod mesh_comparison;
mod motions;
mod movement;
mod refinement;
mod rod_sections;
mod sentence;
mod shape_gaps;
mod value_errors;

pub use body_errors::BodyError;
pub use discretisation_errors::{DiscretisationErrors, EigenvalueError, Resolution};
pub(crate) use factor_errors::FactorErrors;
pub use finer::FinerMesh;
pub(crate) use finer::{GIVEN_START, HalvedModel};
pub(crate) use frequency_errors::FrequencyErrors;
pub(crate) use gap_field::GapField;
pub(crate) use mesh_comparison::MeshComparison;
pub(crate) use motions::{EstimateHistory, MotionEstimate, has_mesh};
pub use motions::{MotionErrors, ProbeErrors};
pub(crate) use movement::{coordinate_sizes, moved};
pub use refinement::{MeshStep, Refinement, RefinementStep};
pub use value_errors::{ProbeError, ValueError};
