//! Thin shell element: bicubic Hermite surface with Kirchhoff-Love strains.

mod bent_points;
mod element;
mod hermite;
mod law_element;
mod membrane_stiffness;
mod nonlinear_membrane;
mod profile;
mod rounding;
mod stiffness;
mod surface_state;
mod tables;

pub use element::Shell48;
pub use hermite::VECTORS;
pub use profile::{ShellMedium, ShellProfile};

pub(super) use bent_points::VOIGT;
pub(super) use hermite::{Shape, bicubic, surface_derivatives};
pub(super) use tables::{MEMBRANE, each_sample, integration_points, lagrange, sum};
