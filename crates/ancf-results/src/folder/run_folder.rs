use std::fs::{self, File, TryLockError};
use std::io::{self, Read, Seek, Write};
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

use super::checksum::{damaged, sha256};
use super::whole_file::{remove, remove_all, with_path};

/// Results folder and the paths of its files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Folder(PathBuf);

/// Lock file of a running analysis. It remains afterwards and marks the folder as one of a run.
const LOCK: &str = ".lock";
/// Digits of the contents of the lock file: the SHA-256 of the model of the last run.
const DIGITS: u64 = 64;
/// Maximum number of attempts to lock the folder.
const ATTEMPTS: u32 = 10;
/// Time between two attempts.
const ATTEMPT_INTERVAL: Duration = Duration::from_millis(20);

/// Files of a run, their incomplete versions, and the report.
const FILES: [&str; 15] = [
    "model.toml",
    "model.toml.part",
    "results.parquet",
    "results.parquet.part",
    "states.parquet",
    "states.parquet.part",
    "probes.csv",
    "probes.npz",
    "summary.json",
    "summary.json.part",
    "checkpoint",
    "checkpoint.part",
    "report.html",
    "report.html.part",
    LOCK,
];

/// Folders of a run.
const FOLDERS: [&str; 7] = [
    "display",
    "results.parquet.parts",
    "results.parquet.parts.part",
    "results.parquet.done",
    "states.parquet.parts",
    "states.parquet.parts.part",
    "states.parquet.done",
];

impl Folder {
    /// Folder at a path, which need not exist yet.
    pub fn new(path: impl Into<PathBuf>) -> Self {
        Self(path.into())
    }

    /// Path of the folder.
    pub fn path(&self) -> &Path {
        &self.0
    }

    /// Returns true if a run may write there without mixing its files with others: the folder is that of a run, is empty or does
    /// not exist.
    pub fn is_free(&self) -> bool {
        let is_empty = || fs::read_dir(&self.0).is_ok_and(|mut entries| entries.next().is_none());
        self.0.join(LOCK).exists() || !self.0.exists() || is_empty()
    }

    /// Path of the model.
    pub fn model(&self) -> PathBuf {
        self.0.join("model.toml")
    }

    /// Path of the columns.
    pub fn results(&self) -> PathBuf {
        self.0.join("results.parquet")
    }

    /// Path of the states.
    pub fn states(&self) -> PathBuf {
        self.0.join("states.parquet")
    }

    /// Path of the columns as text.
    pub fn csv(&self) -> PathBuf {
        self.0.join("probes.csv")
    }

    /// Path of the summary.
    pub fn summary(&self) -> PathBuf {
        self.0.join("summary.json")
    }

    /// Path of the checkpoint.
    pub fn checkpoint(&self) -> PathBuf {
        self.0.join("checkpoint")
    }

    /// Returns an error if a run would overwrite files of the user. `lock` contains the checksum of the last run.
    pub(crate) fn check_overwrite(&self, lock: &File, text: &str) -> io::Result<()> {
        let last = signature_of(lock).map_err(|error| with_path(&error, &self.0.join(LOCK)))?;
        let path = self.model();
        let own = match fs::read(&path) {
            Ok(bytes) => Some(bytes),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return Err(with_path(&error, &path)),
        };
        let is_users = |own: &Vec<u8>| own != text.as_bytes() && sha256(own) != last;
        if own.is_some_and(|own| is_users(&own)) {
            return Err(lost(&path));
        }
        let ours = !last.is_empty();
        let others = FILES.iter().chain(&FOLDERS).filter(|name| !["model.toml", LOCK].contains(name));
        let found = others.map(|name| self.0.join(name)).find(|path| path.exists());
        found.filter(|_| !ours).map_or(Ok(()), |path| Err(lost(&path)))
    }

    /// Returns the SHA-256 of the model of the run; `None` if the folder has no lock file or the run is starting, and on Windows
    /// during the run.
    fn signature(&self) -> io::Result<Option<String>> {
        let path = self.0.join(LOCK);
        match File::open(&path).and_then(|lock| signature_of(&lock)) {
            Ok(signature) => Ok(Some(signature).filter(|signature| !signature.is_empty())),
            // Copies of a folder may lack it.
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
            // On Windows nobody else can read a locked file: lock violation.
            Err(error) if cfg!(windows) && error.raw_os_error() == Some(33) => Ok(None),
            Err(error) => Err(with_path(&error, &path)),
        }
    }

    /// Verifies the text of the model. Without a lock file the checksum is `stored`, that of the results.
    pub(crate) fn verify_model(
        &self,
        text: &[u8],
        stored: impl FnOnce() -> io::Result<Option<String>>,
    ) -> io::Result<()> {
        let signature = match self.signature()? {
            Some(signature) => Some(signature),
            None => stored()?,
        };
        if signature.is_none_or(|signature| signature == sha256(text)) {
            return Ok(());
        }
        let why = format!(
            "it is not the model of this run, its SHA-256 differs from {LOCK} or the results; to change a model, run a copy \
             of it into another folder"
        );
        Err(with_path(&damaged(&why), &self.model()))
    }

    /// Removes the files of an earlier run, so that they are not confused with those of this run.
    pub(crate) fn clear(&self) -> io::Result<()> {
        let files = FILES.iter().filter(|name| **name != LOCK);
        files.map(|name| self.0.join(name)).try_for_each(|path| remove(&path))?;
        FOLDERS.iter().map(|name| self.0.join(name)).try_for_each(|path| remove_all(&path))
    }

    /// Removes incomplete files of a killed run.
    pub(crate) fn remove_incomplete(&self) -> io::Result<()> {
        let is_incomplete = |name: &&&str| name.ends_with(".part");
        FILES
            .iter()
            .filter(is_incomplete)
            .map(|name| self.0.join(name))
            .try_for_each(|path| remove(&path))?;
        let is_leftover = |name: &&&str| name.ends_with(".part") || name.ends_with(".done");
        FOLDERS
            .iter()
            .filter(is_leftover)
            .map(|name| self.0.join(name))
            .try_for_each(|path| remove_all(&path))
    }

    /// Locks the folder for this process. The lock ends when the file is closed or the process ends.
    pub(crate) fn lock(&self) -> io::Result<File> {
        let path = self.0.join(LOCK);
        let file = File::options()
            .create(true)
            .read(true)
            // Windows cannot truncate files that are opened to append.
            .write(true)
            .truncate(false)
            .open(&path)
            .map_err(|error| with_path(&error, &path))?;
        // `is_busy` of another process locks the file for a moment.
        let mut taken = file.try_lock();
        for _ in 0..ATTEMPTS {
            if taken.is_ok() {
                break;
            }
            thread::sleep(ATTEMPT_INTERVAL);
            taken = file.try_lock();
        }
        match taken {
            Ok(()) => Ok(file),
            Err(TryLockError::WouldBlock) => {
                let text = format!("{}: another run writes into this folder", self.0.display());
                Err(io::Error::new(io::ErrorKind::ResourceBusy, text))
            }
            // Some file systems do not support locks; the run is then unprotected.
            Err(TryLockError::Error(_)) => Ok(file),
        }
    }

    /// True if the folder contains files of a run besides the model, which may be a file of the user.
    pub fn has_run(&self) -> bool {
        let left = [self.0.join(LOCK), self.results(), self.states(), self.csv(), self.summary()];
        left.iter().any(|path| path.exists())
    }

    /// True if a run is writing into the folder.
    pub fn is_busy(&self) -> bool {
        let file = File::open(self.0.join(LOCK));
        file.is_ok_and(|file| matches!(file.try_lock_shared(), Err(TryLockError::WouldBlock)))
    }
}

/// Returns the checksum in a lock file, which may be empty.
fn signature_of(mut lock: &File) -> io::Result<String> {
    lock.rewind()?;
    let mut signature = Vec::new();
    lock.take(DIGITS).read_to_end(&mut signature)?;
    Ok(String::from_utf8_lossy(&signature).into_owned())
}

/// Error of a file of the user that would be overwritten.
pub(crate) fn lost(path: &Path) -> io::Error {
    let text = format!(
        "{} is not a file of a run, or was changed, and would be lost: choose another folder",
        path.display()
    );
    io::Error::new(io::ErrorKind::AlreadyExists, text)
}

/// Removes the checksum of the model of an earlier run from the lock file.
pub(crate) fn erase_signature(lock: &File) -> io::Result<()> {
    lock.set_len(0)
}

/// Writes the checksum of the model of a run into its lock file, which is empty.
pub(crate) fn sign(lock: &mut File, text: &str) -> io::Result<()> {
    lock.rewind()?;
    lock.write_all(sha256(text.as_bytes()).as_bytes())
}
