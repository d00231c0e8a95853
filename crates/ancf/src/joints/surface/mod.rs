//! Supports and seams of shells, and beams along shells.

mod condition;
mod edge_equations;
mod mesh_equations;
mod mesh_seam;
mod seam;
mod seam_equations;
mod support;
mod tie;
mod tie_equations;
mod tie_feet;

pub use condition::{SeamCondition, SupportCondition, SupportedAxis};
pub use seam::Seam;
pub use support::Support;
pub use tie::Tie;
