use std::io;
use std::path::{Path, PathBuf};

use ancf::{ModelErrors, StepError};
use thiserror::Error;

/// Version of the standard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fmi {
    /// FMI 2.0.
    Two,
    /// FMI 3.0.
    Three,
}

/// Options of an export.
#[derive(Clone, Debug)]
pub struct Options<'a> {
    /// Name of the model.
    pub name: &'a str,
    /// Version of the standard.
    pub version: Fmi,
    /// Keys of the model that can be set, each with its value, or with that of the model.
    pub parameters: &'a [(String, Option<f64>)],
    /// Shared library of this version of the crate.
    pub library: &'a Path,
}

/// Error of an export.
#[derive(Debug, Error)]
pub enum ExportError {
    /// The model is not valid.
    #[error(transparent)]
    Model(#[from] ModelErrors),
    /// The model has no motion that can be advanced step by step.
    #[error(transparent)]
    Motion(#[from] StepError),
    /// A parameter is not valid.
    #[error("parameter {path}: {reason}")]
    Parameter {
        /// Path of the key.
        path: String,
        /// Reason.
        reason: String,
    },
    /// A variable has the name of another one.
    #[error("two variables have the name {0:?}; rename the input")]
    Name(String),
    /// The shared library is missing or of another version.
    #[error("{path}: {reason}")]
    Library {
        /// Path of the library.
        path: PathBuf,
        /// Reason.
        reason: String,
    },
    /// The file cannot be written.
    #[error(transparent)]
    Write(#[from] io::Error),
}
