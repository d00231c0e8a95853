//! Files of one folder.

use std::fs::File;
use std::path::{Component, Path, PathBuf};

use super::reply::TEXT;

/// Open file with its media type.
pub(super) struct OpenFile {
    pub(super) kind: &'static str,
    pub(super) file: File,
    pub(super) length: u64,
}

/// Opens the file at a path of a request within a folder; `None` if the path is not a regular file in the folder.
pub(super) fn file(folder: &Path, sent: &str) -> Option<OpenFile> {
    let path = within(folder, &decoded(sent)?)?;
    let file = File::open(&path).ok()?;
    let data = file.metadata().ok().filter(std::fs::Metadata::is_file)?;
    Some(OpenFile { kind: kind(&path), file, length: data.len() })
}

/// Decodes the percent-encoding of a path, once.
fn decoded(sent: &str) -> Option<String> {
    let (mut bytes, mut rest) = (Vec::new(), sent.as_bytes().iter());
    while let Some(&byte) = rest.next() {
        if byte != b'%' {
            bytes.push(byte);
            continue;
        }
        let mut digit = || rest.next().and_then(|digit| char::from(*digit).to_digit(16));
        let (high, low) = (digit()?, digit()?);
        bytes.push((16 * high + low) as u8);
    }
    String::from_utf8(bytes).ok().filter(|path| !path.contains(['\0', '\\', ':']))
}

/// Resolves a path with its links; `None` if it is not a regular file in the folder.
fn within(folder: &Path, path: &str) -> Option<PathBuf> {
    let path = Path::new(path);
    let plain = path.components().all(|part| matches!(part, Component::Normal(_)));
    if !plain || path.as_os_str().is_empty() {
        return None;
    }
    let folder = folder.canonicalize().ok()?;
    let path = folder.join(path).canonicalize().ok()?;
    (path.starts_with(&folder) && path.is_file()).then_some(path)
}

/// Media type of a file, never one that browsers execute.
fn kind(path: &Path) -> &'static str {
    match path.extension().and_then(|end| end.to_str()) {
        Some("toml" | "txt" | "log" | "md") => TEXT,
        Some("json") => "application/json",
        Some("csv") => "text/csv; charset=utf-8",
        Some("png") => "image/png",
        _ => "application/octet-stream",
    }
}
