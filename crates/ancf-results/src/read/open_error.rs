use std::io;
use std::path::PathBuf;

use ancf::model::ModelErrors;
use thiserror::Error;

/// Error of reading the results of a run.
#[derive(Debug, Error)]
pub enum OpenError {
    /// The folder contains no run.
    #[error("{0} contains no run: there is no model.toml")]
    NoRun(PathBuf),
    /// The folder contains the results of several analyses.
    #[error("{} contains the results of several analyses: choose one of its folders {}", .folder.display(), .analyses.join(", "))]
    Sequence {
        /// Results folder of the sequence.
        folder: PathBuf,
        /// Names of the folders of its analyses.
        analyses: Vec<String>,
    },
    /// The model is invalid in this version of the program.
    #[error("{path}: {errors}")]
    Model {
        /// Path of the model.
        path: PathBuf,
        /// Errors of the model.
        errors: ModelErrors,
    },
    /// A file cannot be read.
    #[error(transparent)]
    Read(#[from] io::Error),
}
