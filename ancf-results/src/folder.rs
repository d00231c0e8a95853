use std::fs::{self, File, TryLockError};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// The files of a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Folder(PathBuf);

/// What a run holds while it goes on, and leaves as a sign that the folder is one of a run.
const LOCK: &str = ".lock";

/// Files and folders that a run may leave.
const OURS: [&str; 10] = [
    "model.toml",
    "results.parquet",
    "results.parquet.parts",
    "states.parquet",
    "states.parquet.parts",
    "probes.csv",
    "probes.npz",
    "summary.json",
    "checkpoint",
    "report.html",
];

impl Folder {
    /// The folder at a path, which need not be there yet.
    pub fn new(path: impl Into<PathBuf>) -> Self {
        Self(path.into())
    }

    /// Its path.
    pub fn path(&self) -> &Path {
        &self.0
    }

    /// The text of the model.
    pub fn model(&self) -> PathBuf {
        self.0.join("model.toml")
    }

    /// The columns.
    pub fn results(&self) -> PathBuf {
        self.0.join("results.parquet")
    }

    /// The states.
    pub fn states(&self) -> PathBuf {
        self.0.join("states.parquet")
    }

    /// The columns as text.
    pub fn csv(&self) -> PathBuf {
        self.0.join("probes.csv")
    }

    /// How the run ended.
    pub fn summary(&self) -> PathBuf {
        self.0.join("summary.json")
    }

    /// Where the run can be continued.
    pub fn checkpoint(&self) -> PathBuf {
        self.0.join("checkpoint")
    }

    /// Refuses a folder that has a model of the user in the place of that of a run.
    pub(crate) fn spare(&self, text: &str) -> io::Result<()> {
        let path = self.model();
        let is_run = self.0.join(LOCK).exists();
        match fs::read_to_string(&path) {
            Ok(own) if !is_run && own != text => {
                let text =
                    format!("{} is not of a run and would be lost: take another folder", path.display());
                Err(io::Error::new(io::ErrorKind::AlreadyExists, text))
            }
            _ => Ok(()),
        }
    }

    /// Removes what an earlier run left: it must not be taken for results of this one.
    pub(crate) fn clear(&self) -> io::Result<()> {
        fs::create_dir_all(&self.0).map_err(|error| about(&error, &self.0))?;
        OURS.iter().map(|name| self.0.join(name)).try_for_each(|path| remove(&path))
    }

    /// Takes the folder for this process; it is free again when the lock is dropped, however the process ends.
    pub(crate) fn lock(&self) -> io::Result<File> {
        let path = self.0.join(LOCK);
        let file =
            File::options().create(true).append(true).open(&path).map_err(|error| about(&error, &path))?;
        match file.try_lock() {
            Ok(()) => Ok(file),
            Err(TryLockError::WouldBlock) => {
                let text = format!("{}: another run writes into this folder", self.0.display());
                Err(io::Error::new(io::ErrorKind::ResourceBusy, text))
            }
            // Where files cannot be locked, nobody is kept out.
            Err(TryLockError::Error(_)) => Ok(file),
        }
    }

    /// Whether a run writes into it right now.
    pub fn is_busy(&self) -> bool {
        let file = File::open(self.0.join(LOCK));
        file.is_ok_and(|file| matches!(file.try_lock_shared(), Err(TryLockError::WouldBlock)))
    }
}

/// An error with the path that it is about.
pub(crate) fn about(error: &io::Error, path: &Path) -> io::Error {
    io::Error::new(error.kind(), format!("{}: {error}", path.display()))
}

/// Removes a file or a folder, which may not be there.
pub(crate) fn remove(path: &Path) -> io::Result<()> {
    let removed = if path.is_dir() { fs::remove_dir_all(path) } else { fs::remove_file(path) };
    match removed {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(about(&error, path)),
        _ => Ok(()),
    }
}

/// Where a file stands until it is whole.
pub(crate) fn beside(path: &Path) -> PathBuf {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(".part");
    path.with_file_name(name)
}

/// Writes a file: all of it or nothing, on the disk when this returns.
pub(crate) fn replace(path: &Path, contents: &[u8]) -> io::Result<()> {
    let part = beside(path);
    let write = || {
        let mut file = File::create(&part)?;
        file.write_all(contents)?;
        file.sync_all()?;
        fs::rename(&part, path)
    };
    write().map_err(|error| {
        let _ = fs::remove_file(&part);
        about(&error, path)
    })
}
