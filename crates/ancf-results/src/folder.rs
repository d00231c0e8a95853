use std::fs::{self, File, TryLockError};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

use crate::provenance::sha256;

/// The files of a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Folder(PathBuf);

/// What a run holds while it goes on, and leaves as a sign that the folder is one of a run.
const LOCK: &str = ".lock";
/// Digits of what stands in it: the SHA-256 of the model of the last run.
const SUM: u64 = 64;
/// How often and in what time it is tried to take it.
const LOOKS: u32 = 10;
const LOOK: Duration = Duration::from_millis(20);

/// Files that a run may leave, those among them that it did not complete, and what is made of it.
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

/// Folders that a run may leave.
const FOLDERS: [&str; 6] = [
    "results.parquet.parts",
    "results.parquet.parts.part",
    "results.parquet.done",
    "states.parquet.parts",
    "states.parquet.parts.part",
    "states.parquet.done",
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

    /// Refuses a folder that has files of the user in the place of those of a run. `lock` tells of the last run.
    pub(crate) fn spare(&self, lock: &File, text: &str) -> io::Result<()> {
        let mut last = String::new();
        lock.take(SUM).read_to_string(&mut last).map_err(|error| about(&error, &self.0.join(LOCK)))?;
        let path = self.model();
        let own = match fs::read(&path) {
            Ok(bytes) => Some(bytes),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return Err(about(&error, &path)),
        };
        let is_lost = |own: &Vec<u8>| own != text.as_bytes() && sha256(own) != last;
        if own.is_some_and(|own| is_lost(&own)) {
            return Err(lost(&path));
        }
        let ours = !last.is_empty();
        let others = FILES.iter().chain(&FOLDERS).filter(|name| !["model.toml", LOCK].contains(name));
        let found = others.map(|name| self.0.join(name)).find(|path| path.exists());
        found.filter(|_| !ours).map_or(Ok(()), |path| Err(lost(&path)))
    }

    /// Removes what an earlier run left: it must not be taken for results of this one.
    pub(crate) fn clear(&self) -> io::Result<()> {
        let files = FILES.iter().filter(|name| **name != LOCK);
        files.map(|name| self.0.join(name)).try_for_each(|path| remove(&path))?;
        FOLDERS.iter().map(|name| self.0.join(name)).try_for_each(|path| remove_all(&path))
    }

    /// Removes what a run that was killed did not complete.
    pub(crate) fn sweep(&self) -> io::Result<()> {
        let is_part = |name: &&&str| name.ends_with(".part");
        FILES.iter().filter(is_part).map(|name| self.0.join(name)).try_for_each(|path| remove(&path))?;
        let is_rest = |name: &&&str| name.ends_with(".part") || name.ends_with(".done");
        FOLDERS.iter().filter(is_rest).map(|name| self.0.join(name)).try_for_each(|path| remove_all(&path))
    }

    /// Takes the folder for this process; it is free again when the lock is dropped, however the process ends.
    pub(crate) fn lock(&self) -> io::Result<File> {
        let path = self.0.join(LOCK);
        let file = File::options()
            .create(true)
            .read(true)
            .append(true)
            .open(&path)
            .map_err(|error| about(&error, &path))?;
        // Who only looks whether it is taken takes it for a moment.
        let mut taken = file.try_lock();
        for _ in 0..LOOKS {
            if taken.is_ok() {
                break;
            }
            thread::sleep(LOOK);
            taken = file.try_lock();
        }
        match taken {
            Ok(()) => Ok(file),
            Err(TryLockError::WouldBlock) => {
                let text = format!("{}: another run writes into this folder", self.0.display());
                Err(io::Error::new(io::ErrorKind::ResourceBusy, text))
            }
            // Where files cannot be locked, nobody is kept out.
            Err(TryLockError::Error(_)) => Ok(file),
        }
    }

    /// Whether a run has left anything in it but a model, which may be the user's own.
    pub fn has_run(&self) -> bool {
        let left = [self.0.join(LOCK), self.results(), self.states(), self.csv(), self.summary()];
        left.iter().any(|path| path.exists())
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

fn lost(path: &Path) -> io::Error {
    let text =
        format!("{} is not of a run, or was changed, and would be lost: take another folder", path.display());
    io::Error::new(io::ErrorKind::AlreadyExists, text)
}

/// Leaves a sign of the model that a run writes into its folder.
pub(crate) fn sign(lock: &mut File, text: &str) -> io::Result<()> {
    lock.set_len(0)?;
    lock.write_all(sha256(text.as_bytes()).as_bytes())
}

/// Removes a file, which may not be there.
pub(crate) fn remove(path: &Path) -> io::Result<()> {
    gone(fs::remove_file(path), path)
}

/// Removes a folder, which may not be there, with all that is in it.
pub(crate) fn remove_all(path: &Path) -> io::Result<()> {
    gone(fs::remove_dir_all(path), path)
}

fn gone(removed: io::Result<()>, path: &Path) -> io::Result<()> {
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
///
/// # Errors
/// If it cannot be written; what was there before is there still.
pub fn whole(path: &Path, write: impl FnOnce(&File) -> io::Result<()>) -> io::Result<()> {
    let part = beside(path);
    let written = File::create(&part).and_then(|file| {
        write(&file)?;
        file.sync_all()?;
        fs::rename(&part, path)
    });
    written.inspect_err(|_| _ = fs::remove_file(&part))
}

/// Writes a file of these contents; errors name it.
pub(crate) fn replace(path: &Path, contents: &[u8]) -> io::Result<()> {
    whole(path, |mut file| file.write_all(contents)).map_err(|error| about(&error, path))
}
