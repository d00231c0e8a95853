//! The file `layers.toml`.

use std::fs;
use std::path::Path;

use serde::Deserialize;

/// Name of the file at the root of the workspace.
pub(in crate::layers) const FILE: &str = "layers.toml";

/// Contents of `layers.toml`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(in crate::layers) struct Config {
    /// Limits on files and folders.
    pub(in crate::layers) limits: Limits,
    /// Source trees.
    #[serde(rename = "tree")]
    pub(in crate::layers) trees: Vec<TreeConfig>,
}

/// Limits on files and folders.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(in crate::layers) struct Limits {
    /// Source files of a folder. Files that only declare and re-export do not count.
    pub(in crate::layers) files: usize,
    /// Lines of a file.
    pub(in crate::layers) lines: usize,
    /// Folders outside the trees whose files keep the limit on lines.
    #[serde(default)]
    pub(in crate::layers) also: Vec<String>,
    /// Generated files and folders, exempt from both limits.
    #[serde(default)]
    pub(in crate::layers) generated: Vec<String>,
}

/// A source tree and its layers.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(in crate::layers) struct TreeConfig {
    /// Folder, relative to the root of the workspace.
    pub(in crate::layers) path: String,
    /// Language of its files.
    pub(in crate::layers) language: Language,
    /// Folders relative to the tree, from the top layer to the bottom layer. `.` is the tree's own folder.
    pub(in crate::layers) layers: Vec<String>,
}

/// Languages with an import parser.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(in crate::layers) enum Language {
    Rust,
    Python,
    Typescript,
}

impl Language {
    /// Returns the language of a file by its extension.
    pub(in crate::layers) fn of(file: &Path) -> Option<Self> {
        match file.extension()?.to_str()? {
            "rs" => Some(Self::Rust),
            "py" => Some(Self::Python),
            "ts" | "tsx" => Some(Self::Typescript),
            _ => None,
        }
    }
}

impl Config {
    /// Reads the file at the root of a workspace.
    pub(in crate::layers) fn read(root: &Path) -> Result<Self, String> {
        let text = fs::read_to_string(root.join(FILE)).map_err(|error| format!("{FILE}: {error}"))?;
        toml::from_str(&text).map_err(|error| format!("{FILE}: {error}"))
    }
}
