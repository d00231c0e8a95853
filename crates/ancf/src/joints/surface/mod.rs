//! Supports and seams of shells, and beams along shells.

mod bond;
mod bond_equations;
mod bond_feet;
mod condition;
mod edge_equations;
mod mesh_equations;
mod mesh_seam;
mod seam;
mod seam_equations;
mod support;

pub use bond::Bond;
pub use condition::{SeamCondition, SupportCondition, SupportedAxis};
pub use seam::Seam;
pub use support::Support;
