//! Errors of the study engine.

use std::io;
use std::path::PathBuf;

use ancf::ModelErrors;
use thiserror::Error;

/// Failure of a study as a whole. A case that fails is a row of the results, not an error.
#[derive(Debug, Error)]
pub enum StudyError {
    /// The study file or the model file is invalid.
    #[error("{}: {errors}", path.display())]
    Invalid {
        /// Path of the invalid file.
        path: PathBuf,
        /// All errors of the file.
        errors: ModelErrors,
    },
    /// The design has more cases than can be counted.
    #[error("there are more cases than can be counted")]
    TooManyCases,
    /// A file or folder cannot be created, written or read.
    #[error("cannot {action} {}", path.display())]
    File {
        /// `create`, `write` or `read`.
        action: &'static str,
        /// Path of the file or folder.
        path: PathBuf,
        /// Cause.
        source: io::Error,
    },
    /// A table in the results folder is not a table of a study.
    #[error("{} cannot be read; remove it or take another folder for the results", path.display())]
    Table {
        /// Path of the table.
        path: PathBuf,
        /// Cause.
        source: TableError,
    },
}

/// Failure of reading a table.
#[derive(Debug, Error)]
pub enum TableError {
    /// The file cannot be opened.
    #[error(transparent)]
    Open(#[from] io::Error),
    /// The content is not valid Parquet.
    #[error(transparent)]
    Parquet(#[from] parquet::errors::ParquetError),
}
