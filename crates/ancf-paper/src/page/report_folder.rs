//! Folder of a report.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use ancf_results::write_atomically;
use anyhow::{Context, Result};

/// Writable folder of a report.
#[derive(Debug)]
pub struct ReportFolder(PathBuf);

impl ReportFolder {
    /// Creates the folder and checks that it is writable, before the runs.
    ///
    /// # Errors
    /// If the folder cannot be created or is not writable.
    pub fn create(path: &Path) -> Result<Self> {
        fs::create_dir_all(path).with_context(|| format!("cannot create the folder {}", path.display()))?;
        let folder = Self(path.to_owned());
        let trial = folder.0.join(".trial.part");
        fs::write(&trial, "")
            .and_then(|()| fs::remove_file(&trial))
            .with_context(|| format!("cannot write into the folder {}", path.display()))?;
        Ok(folder)
    }

    /// Writes a file. The old file is replaced as a whole.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self, name: &str, contents: impl AsRef<[u8]>) -> Result<()> {
        let path = self.0.join(name);
        write_atomically(&path, |mut file| file.write_all(contents.as_ref()))
            .with_context(|| format!("cannot write {}", path.display()))
    }
}
