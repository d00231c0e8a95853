//! Linear models about states of a motion.

mod differences;
mod input_derivatives;
mod linear_model;
mod linearise;
mod null_space;
mod rate_stiffness;
mod sensitivity;
mod tangents;

pub use linear_model::{DescriptorForm, LinearModel};
