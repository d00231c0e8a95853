//! Models as co-simulation FMUs of the Functional Mock-up Interface, versions 2.0 and 3.0.
//!
//! [`export`] writes an FMU: the description, the model file, and a shared library that is the same for all models. That library is
//! this crate too. It reads the model from the resources of the FMU and advances it by [`ancf::Stepper`].

mod calls;
mod component;
mod export;
mod fmi2;
mod fmi3;
mod interface;
mod memory;

pub use export::{ExportError, Exported, Fmi, Options, export, library_name};
