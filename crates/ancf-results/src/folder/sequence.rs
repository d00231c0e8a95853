use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::checksum::sha256;
use super::run_folder::lost;
use super::whole_file::{with_path, write_atomically};

/// Copy of the model file in the results folder of a sequence of analyses. Each analysis has a folder of its own beside it.
const SEQUENCE: &str = "sequence.toml";
/// File with the SHA-256 of the copy, which differs from that of a file of the user.
const SIGNATURE: &str = ".sequence";

/// Path of the model file of a sequence in its results folder.
pub fn sequence_file(folder: &Path) -> PathBuf {
    folder.join(SEQUENCE)
}

/// Writes the model file of a sequence into its results folder.
///
/// # Errors
/// If the folder or the file cannot be written, or the file exists and is not the copy of an earlier run.
pub fn write_sequence(folder: &Path, text: &str) -> io::Result<()> {
    fs::create_dir_all(folder).map_err(|error| with_path(&error, folder))?;
    let (path, signature) = (sequence_file(folder), folder.join(SIGNATURE));
    match fs::read(&path) {
        Ok(own) => {
            let is_copy = || fs::read_to_string(&signature).is_ok_and(|last| last == sha256(&own));
            if own != text.as_bytes() && !is_copy() {
                return Err(lost(&path));
            }
        }
        Err(error) if error.kind() == io::ErrorKind::NotFound => {}
        Err(error) => return Err(with_path(&error, &path)),
    }
    let digits = sha256(text.as_bytes());
    write_atomically(&signature, |mut file| file.write_all(digits.as_bytes()))?;
    write_atomically(&path, |mut file| file.write_all(text.as_bytes()))
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
