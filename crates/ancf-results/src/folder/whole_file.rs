use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

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

/// Writes a file completely or not at all. The contents are on the disk when this returns.
///
/// # Errors
/// If the file cannot be written. An existing file is then unchanged.
pub fn write_atomically(path: &Path, write: impl FnOnce(&File) -> io::Result<()>) -> io::Result<()> {
    let part = part_path(path);
    let written = create(&part).and_then(|file| {
        write(&file)?;
        file.sync_all()?;
        fs::rename(&part, path)
    });
    written.inspect_err(|_| _ = fs::remove_file(&part))
}

/// Writes a file with some contents. Errors contain its path.
pub(crate) fn replace(path: &Path, contents: &[u8]) -> io::Result<()> {
    write_atomically(path, |mut file| file.write_all(contents)).map_err(|error| with_path(&error, path))
}
