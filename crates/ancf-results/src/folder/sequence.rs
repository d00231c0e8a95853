use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::whole_file::write_atomically;

/// Copy of the model file in the results folder of a sequence of analyses. Each analysis has a folder of its own beside it.
const SEQUENCE: &str = "sequence.toml";

/// Path of the model file of a sequence in its results folder.
pub fn sequence_file(folder: &Path) -> PathBuf {
    folder.join(SEQUENCE)
}

/// Writes the model file of a sequence into its results folder.
///
/// # Errors
/// If the folder or the file cannot be written.
pub fn write_sequence(folder: &Path, text: &str) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    write_atomically(&sequence_file(folder), |mut file| file.write_all(text.as_bytes()))
}

/// Names of the results folders of a sequence, in the order of its analyses; `None` if the folder is none of a sequence.
pub(crate) fn sequence_folders(folder: &Path) -> Option<Vec<String>> {
    if !sequence_file(folder).is_file() {
        return None;
    }
    let names = fs::read_dir(folder).into_iter().flatten().flatten();
    let numbered = |name: String| Some((name.split_once('-')?.0.parse::<u32>().ok()?, name));
    let mut found: Vec<_> =
        names.filter_map(|entry| numbered(entry.file_name().into_string().ok()?)).collect();
    found.sort();
    Some(found.into_iter().map(|(_, name)| name).collect())
}
