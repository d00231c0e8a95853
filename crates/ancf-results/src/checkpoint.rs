use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

use serde::Serialize;
use serde::de::DeserializeOwned;
use sha2::{Digest, Sha256};
use thiserror::Error;

use crate::folder::{about, replace};

/// How often a checkpoint is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Every {
    /// After so many steps.
    Steps(u64),
    /// After so much time of the clock.
    Time(Duration),
}

/// Why a checkpoint cannot be read.
#[derive(Debug, Error)]
pub enum CheckpointError {
    /// The file could not be read.
    #[error(transparent)]
    Read(#[from] io::Error),
    /// It is not what was written.
    #[error("{path}: the checkpoint is damaged, {why}: remove it, and the run begins anew")]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        why: &'static str,
    },
}

/// The first bytes of a checkpoint; the last one is the version of its format.
const HEAD: [u8; 8] = *b"ANCFCP\0\x01";

/// Writes a checkpoint: head, contents, SHA-256 of both.
pub(crate) fn write(path: &Path, contents: &impl Serialize) -> io::Result<()> {
    let mut bytes = postcard::to_extend(contents, HEAD.to_vec()).map_err(io::Error::other)?;
    let sum = Sha256::digest(&bytes);
    bytes.extend_from_slice(&sum);
    replace(path, &bytes)
}

/// Reads a checkpoint; nothing if there is none.
pub(crate) fn read<T: DeserializeOwned>(path: &Path) -> Result<Option<T>, CheckpointError> {
    match fs::read(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        bytes => {
            let bytes = bytes.map_err(|error| about(&error, path))?;
            let damaged = |why| CheckpointError::Damaged { path: path.to_owned(), why };
            from_bytes(&bytes).map(Some).map_err(damaged)
        }
    }
}

fn from_bytes<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, &'static str> {
    let (contents, sum) = bytes.split_last_chunk::<32>().ok_or("it is too short")?;
    if !contents.starts_with(&HEAD) {
        return Err("it is none of this version of the program");
    }
    if Sha256::digest(contents).as_slice() != sum {
        return Err("its sum does not fit");
    }
    postcard::from_bytes(&contents[HEAD.len()..]).map_err(|_| "it is none of this version of the program")
}
