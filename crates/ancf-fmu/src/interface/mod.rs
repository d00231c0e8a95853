//! Variables of an FMU, which the export writes and the library inside it reads.

mod files;
mod variables;

pub use files::{INTERFACE, MARKER, MODEL, model_with};
pub use variables::{Input, Interface, Parameter, Variable};
