//! Folder of a study.

use std::path::Path;

use ancf_study::StudyRecord;
use anyhow::Result;

/// Reads the study in a folder; `None` if the folder has no study.
///
/// # Errors
/// If a table cannot be read.
pub fn open_study(folder: &Path) -> Result<Option<StudyRecord>> {
    if StudyRecord::files(folder).is_empty() {
        return Ok(None);
    }
    Ok(Some(StudyRecord::read(folder)?))
}
