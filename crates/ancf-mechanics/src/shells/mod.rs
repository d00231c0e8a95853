//! Thin shells: bicubic Hermite elements with Kirchhoff-Love strains.

mod element;
mod hermite;
mod profile;
mod rounding;
mod section;
mod stiffness;
mod surface_state;

pub use element::Shell48;
pub(crate) use hermite::bicubic;
pub use hermite::VECTORS;
pub use profile::{ShellMedium, ShellProfile};
pub use section::ShellSection;
