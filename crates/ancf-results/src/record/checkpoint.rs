use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

use serde::Serialize;
use serde::de::DeserializeOwned;
use sha2::{Digest, Sha256};
use thiserror::Error;

use crate::folder::{replace, with_path};

/// Interval between checkpoints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CheckpointInterval {
    /// Number of steps.
    Steps(u64),
    /// Wall-clock time.
    Time(Duration),
}

/// Error of reading a checkpoint.
#[derive(Debug, Error)]
pub enum CheckpointError {
    /// The file cannot be read.
    #[error(transparent)]
    Read(#[from] io::Error),
    /// The contents are invalid.
    #[error("{path}: the checkpoint is damaged, {why}: remove it to start the run from the beginning")]
    Damaged {
        /// Path of the file.
        path: PathBuf,
        /// Kind of damage.
        why: &'static str,
    },
}

/// First bytes of a checkpoint. The last of them is the version of the format.
const HEAD: [u8; 8] = *b"ANCFCP\0\x02";

/// Writes a checkpoint: head, contents, SHA-256 of both.
pub(super) fn write(path: &Path, contents: &impl Serialize) -> io::Result<()> {
    let mut bytes = postcard::to_extend(contents, HEAD.to_vec()).map_err(io::Error::other)?;
    let sum = Sha256::digest(&bytes);
    bytes.extend_from_slice(&sum);
    replace(path, &bytes)
}

/// Reads a checkpoint; `None` if there is no file.
pub(super) fn read<T: DeserializeOwned>(path: &Path) -> Result<Option<T>, CheckpointError> {
    match fs::read(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        bytes => {
            let bytes = bytes.map_err(|error| with_path(&error, path))?;
            let damaged = |why| CheckpointError::Damaged { path: path.to_owned(), why };
            from_bytes(&bytes).map(Some).map_err(damaged)
        }
    }
}

fn from_bytes<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, &'static str> {
    let (contents, checksum) = bytes.split_last_chunk::<32>().ok_or("it is too short")?;
    if !contents.starts_with(&HEAD) {
        return Err("its format is not that of this version of the program");
    }
    if Sha256::digest(contents).as_slice() != checksum {
        return Err("its checksum is wrong");
    }
    postcard::from_bytes(&contents[HEAD.len()..])
        .map_err(|_| "its format is not that of this version of the program")
}
