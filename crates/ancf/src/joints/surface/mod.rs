//! Supports and seams of shells.

mod condition;
mod edge_equations;
mod mesh_equations;
mod mesh_seam;
mod seam;
mod seam_equations;
mod support;

pub use condition::{SeamCondition, SupportCondition, SupportedAxis};
pub use seam::Seam;
pub use support::Support;
