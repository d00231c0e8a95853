use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::thread;
use std::time::{Duration, Instant};

/// Adds a path to an error.
pub(crate) fn with_path(error: &io::Error, path: &Path) -> io::Error {
    io::Error::new(error.kind(), format!("{}: {error}", path.display()))
}

/// Removes a file if it exists.
pub(crate) fn remove(path: &Path) -> io::Result<()> {
    ignore_absence(fs::remove_file(path), path)
}

/// Removes a folder and its contents if it exists.
pub(crate) fn remove_all(path: &Path) -> io::Result<()> {
    ignore_absence(fs::remove_dir_all(path), path)
}

fn ignore_absence(removed: io::Result<()>, path: &Path) -> io::Result<()> {
    match removed {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(with_path(&error, path)),
        _ => Ok(()),
    }
}

/// Returns the path of a file or folder while it is incomplete.
pub(crate) fn part_path(path: &Path) -> PathBuf {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(".part");
    path.with_file_name(name)
}

/// Creates a file that can also be read, or truncates an existing one.
pub(crate) fn create(path: &Path) -> io::Result<File> {
    File::options().read(true).write(true).create(true).truncate(true).open(path)
}

/// Renames a file or folder and replaces an existing file.
///
/// # Errors
/// On Windows, if another program has the file open and does not share it. Virus scanners do so for moments, so renaming is
/// repeated for a second.
pub(crate) fn rename(from: &Path, to: &Path) -> io::Result<()> {
    let start = Instant::now();
    loop {
        match fs::rename(from, to) {
            Err(error) if is_in_use(&error) && start.elapsed() < PATIENCE => {
                thread::sleep(Duration::from_millis(20));
            }
            Err(error) if is_in_use(&error) && to.exists() => {
                let message = format!("{error} Is the file open in another program?");
                return Err(io::Error::new(error.kind(), message));
            }
            done => return done,
        }
    }
}

/// Duration of repeated renaming.
const PATIENCE: Duration = Duration::from_secs(1);

/// True for the errors of Windows if a file is open: access denied, sharing violation, lock violation.
fn is_in_use(error: &io::Error) -> bool {
    cfg!(windows) && matches!(error.raw_os_error(), Some(5 | 32 | 33))
}

/// Writes a file completely or not at all. The contents are on the disk when this returns.
///
/// # Errors
/// If the file cannot be written. An existing file is then unchanged.
pub fn write_atomically(path: &Path, write: impl FnOnce(&File) -> io::Result<()>) -> io::Result<()> {
    let part = part_path(path);
    let written = create(&part).and_then(|file| {
        write(&file)?;
        file.sync_all()?;
        rename(&part, path)
    });
    written.inspect_err(|_| _ = fs::remove_file(&part))
}

/// Writes a file with some contents. Errors contain its path.
pub(crate) fn replace(path: &Path, contents: &[u8]) -> io::Result<()> {
    write_atomically(path, |mut file| file.write_all(contents)).map_err(|error| with_path(&error, path))
}
