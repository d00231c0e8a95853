//! Files of the tables in the folder of a study.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

use ancf_results::verify_checksums;
use parquet::file::reader::SerializedFileReader;

use super::error::{StudyError, TableError};

/// Returns the tables in a folder in alphabetical order; none if the folder does not exist.
///
/// # Errors
/// If the folder cannot be read.
pub fn table_files(folder: &Path) -> Result<Vec<PathBuf>, StudyError> {
    let unreadable = |source| StudyError::File { action: "read", path: folder.to_owned(), source };
    let entries = match fs::read_dir(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        entries => entries.map_err(unreadable)?,
    };
    let mut files = Vec::new();
    for entry in entries {
        let path = entry.map_err(unreadable)?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if name.starts_with("cases") && name.ends_with(".parquet") {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

/// Opens a table whose checksums are correct. Tables of the Python package and of earlier versions have none.
///
/// # Errors
/// If the table cannot be read, or is damaged.
pub(crate) fn open_table(path: &Path) -> Result<SerializedFileReader<File>, TableError> {
    verify_checksums(path)?;
    Ok(SerializedFileReader::new(File::open(path)?)?)
}
