//! Imports between Python files.

use super::config::TreeConfig;
use super::import::Import;
use super::source::SourceFile;

/// Collects the imports of a Python package.
pub(super) fn imports(_tree: usize, _rule: &TreeConfig, _files: &mut [SourceFile]) -> Vec<Import> {
    Vec::new()
}
