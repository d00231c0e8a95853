//! The folder that the report is written into.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use ancf_results::whole;
use anyhow::{Context, Result};

/// A folder that can be written into.
#[derive(Debug)]
pub struct Output(PathBuf);

impl Output {
    /// Creates the folder and finds out now, not after the runs, whether files can be made in it.
    ///
    /// # Errors
    /// If it cannot be created or written into.
    pub fn create(path: &Path) -> Result<Self> {
        fs::create_dir_all(path).with_context(|| format!("cannot create the folder {}", path.display()))?;
        let output = Self(path.to_owned());
        let trial = output.0.join(".trial.part");
        fs::write(&trial, "")
            .and_then(|()| fs::remove_file(&trial))
            .with_context(|| format!("cannot write into the folder {}", path.display()))?;
        Ok(output)
    }

    /// Writes a file that is either the old one or the new one at any time, never half of it.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn write(&self, name: &str, contents: impl AsRef<[u8]>) -> Result<()> {
        let path = self.0.join(name);
        whole(&path, |mut file| file.write_all(contents.as_ref()))
            .with_context(|| format!("cannot write {}", path.display()))
    }
}
