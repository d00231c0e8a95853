//! The folder of an earlier run.

use std::path::Path;

use ancf_results::{OpenError, Results};
use anyhow::Result;

use crate::command::{Ended, refuse, reject};

/// Opens the folder of a run, or says why there is none.
///
/// # Errors
/// If a file cannot be read.
pub fn open(folder: &Path) -> Result<Result<Results, Ended>> {
    match Results::open(folder) {
        Ok(results) if has_run(&results) => Ok(Ok(results)),
        Ok(_) => Ok(Err(reject(&format!(
            "{} holds no run: there is a model.toml and no results",
            folder.display()
        )))),
        Err(OpenError::Model { path, errors }) => Ok(Err(refuse(&errors, &path))),
        Err(error @ OpenError::NoRun(_)) => Ok(Err(reject(&error.to_string()))),
        Err(error) => Err(error.into()),
    }
}

/// Whether a run was there: a model alone may be the user's own, which is not to be written over.
fn has_run(results: &Results) -> bool {
    let folder = results.folder();
    let left =
        [folder.path().join(".lock"), folder.results(), folder.states(), folder.csv(), folder.summary()];
    left.iter().any(|path| path.exists())
}
