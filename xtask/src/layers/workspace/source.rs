//! Source files of the trees, each with its layer.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use super::config::{Language, TreeConfig};

/// A file of a tree.
#[derive(Debug)]
pub(in crate::layers) struct SourceFile {
    /// Index of the tree.
    pub(in crate::layers) tree: usize,
    /// Path relative to the root of the workspace, with `/`.
    pub(in crate::layers) path: String,
    /// Path relative to the tree, with `/`.
    pub(in crate::layers) inner: String,
    /// Folder relative to the tree, `.` for the tree itself. A Rust file `a.rs` beside a folder `a` belongs to `a`.
    pub(in crate::layers) folder: String,
    /// Contents.
    pub(in crate::layers) text: String,
    /// True if the file only declares modules and re-exports names.
    pub(in crate::layers) is_facade: bool,
}

impl SourceFile {
    /// Returns the number of lines.
    pub(in crate::layers) fn lines(&self) -> usize {
        self.text.lines().count()
    }
}

/// Reads the files of all trees.
pub(in crate::layers) fn read(root: &Path, trees: &[TreeConfig]) -> Result<Vec<SourceFile>, String> {
    let mut files = Vec::new();
    for (tree, config) in trees.iter().enumerate() {
        let inner = list(&root.join(&config.path), config.language)?;
        let folders: BTreeSet<String> = inner.iter().map(|path| parent(path).to_owned()).collect();
        for inner in inner {
            let path = format!("{}/{inner}", config.path);
            let text = fs::read_to_string(root.join(&path)).map_err(|error| format!("{path}: {error}"))?;
            let own = inner.strip_suffix(".rs").filter(|stem| folders.contains(*stem));
            let folder = own.unwrap_or_else(|| parent(&inner)).to_owned();
            files.push(SourceFile { tree, path, inner, folder, text, is_facade: false });
        }
    }
    Ok(files)
}

/// Lists the files of a language below a folder, relative to it and sorted.
pub(in crate::layers) fn list(folder: &Path, language: Language) -> Result<Vec<String>, String> {
    let mut found = Vec::new();
    collect(folder, "", &mut |inner| {
        if Language::of(Path::new(&inner)) == Some(language) {
            found.push(inner);
        }
    })?;
    found.sort();
    Ok(found)
}

/// Visits all files below a folder by their paths relative to it. Hidden folders and build output are left out.
pub(in crate::layers) fn collect(
    folder: &Path,
    inner: &str,
    visit: &mut impl FnMut(String),
) -> Result<(), String> {
    let wrong = |error| format!("{}: {error}", folder.display());
    for entry in fs::read_dir(folder).map_err(wrong)? {
        let path = entry.map_err(wrong)?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let inner = if inner.is_empty() { name.clone() } else { format!("{inner}/{name}") };
        let is_output = ["target", "node_modules", "__pycache__"].contains(&name.as_str());
        if path.is_dir() && !is_output && !name.starts_with('.') {
            collect(&path, &inner, visit)?;
        } else if path.is_file() {
            visit(inner);
        }
    }
    Ok(())
}

/// Returns the folder of a relative path, `.` at its root.
pub(in crate::layers) fn parent(path: &str) -> &str {
    path.rsplit_once('/').map_or(".", |(folder, _)| folder)
}
