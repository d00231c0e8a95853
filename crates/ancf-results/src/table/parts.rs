use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::folder::with_path;

/// Returns the folder of the parts of a table.
pub(super) fn parts_folder(path: &Path) -> PathBuf {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(".parts");
    path.with_file_name(name)
}

/// Returns the path of a part of a table.
pub(super) fn part(path: &Path, number: usize) -> PathBuf {
    parts_folder(path).join(format!("part-{number:06}.parquet"))
}

/// Returns the numbers of the existing parts in ascending order.
pub(super) fn part_numbers(path: &Path) -> io::Result<Vec<usize>> {
    let number = |name: &str| name.strip_prefix("part-")?.strip_suffix(".parquet")?.parse().ok();
    let folder = parts_folder(path);
    let entries = fs::read_dir(&folder).map_err(|error| with_path(&error, &folder))?;
    let mut numbers: Vec<usize> =
        entries.flatten().filter_map(|entry| number(&entry.file_name().to_string_lossy())).collect();
    numbers.sort_unstable();
    Ok(numbers)
}
